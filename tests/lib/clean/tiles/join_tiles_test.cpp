/// Tiles, cleaned alone and joined, compared with the whole mesh cleaned at once.
#include "clean/tiles/join_tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "clean/box/clean_box.h"
#include "clean/tiles/split_tiles.h"
#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

namespace {

using Corners = std::array<std::array<double, 3>, 3>;

std::vector<Corners> sorted_triangles(const Mesh& mesh) {
  std::vector<Corners> result;
  for (const Face& face : mesh.faces) {
    Corners t;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.positions[face[i]];
      t[i] = {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

void clean_file(const std::string& from, const std::string& to, int level) {
  Document document = read_mesh(test::content_of(from), from).document;
  const Tile tile = *tile_of(document.style.comments);
  CleanOptions options;
  options.winding_level = level;
  document.mesh = clean_tile(document.mesh, tile, options, Progress()).mesh;
  document.style.comments = {"kept", cleaned_tile_comment(tile.name)};
  test::make_file(to, write_mesh(document).bytes);
}

void split(const Mesh& mesh, std::size_t count, const test::TemporaryFolder& folder) {
  write_mesh_file(folder / "in.ply", mesh);
  SplitResult result = split_tiles(PlyRows(folder / "in.ply"), count, folder / "", Progress());
  for (AtomicFile& file : result.files) file.commit();
}

void clean_all(std::size_t count, int level, const test::TemporaryFolder& folder) {
  for (std::size_t t = 0; t < count; ++t)
    clean_file(tile_path(folder / "", t, count), cleaned_tile_path(folder / "", t, count), level);
}

Document join(const test::TemporaryFolder& folder) {
  AtomicFile file(folder / "out.ply");
  join_tiles(folder / "", "joined", file, Progress());
  file.commit();
  return read_mesh(test::content_of(folder / "out.ply"), "out").document;
}

std::string message_of(const test::TemporaryFolder& folder) {
  try {
    join(folder);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("the joined tiles have the triangles and the vertices of one process") {
  const Mesh folded = test::workload("folded", 4000, 1);
  const Mesh twice = test::joined(folded, test::joined(folded, test::workload("tangle", 3000, 2)));
  // Boxes that touch in sides, edges and corners.
  Mesh blocks;
  for (const Vec3& low : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 1, 0), Vec3(3, 2, 1)})
    for (int i = 0; i < 8; ++i) {
      const Vec3 at = low + .5 * Vec3(i & 1, i >> 1 & 1, i >> 2 & 1);
      blocks = test::joined(blocks, test::cuboid(at, at + Vec3::Constant(.5)));
    }
  for (const Mesh* mesh : std::array<const Mesh*, 3>{&folded, &twice, &blocks}) {
    for (const int level : {1, 2}) {
      if (mesh == &blocks && level == 2) continue;  // no point is in two boxes
      CleanOptions options;
      options.winding_level = level;
      const Mesh expected = clean(*mesh, options).mesh;
      for (const std::size_t count : {2, 7}) {
        const test::TemporaryFolder folder;
        split(*mesh, count, folder);
        clean_all(count, level, folder);
        const Document joined = join(folder);
        CHECK(joined.style.comments == std::vector<std::string>{"kept", "joined"});
        CHECK(sorted_triangles(joined.mesh) == sorted_triangles(expected));
        CHECK(joined.mesh.positions.size() == expected.positions.size());
        const test::Count found = test::count(joined.mesh), wanted = test::count(expected);
        CHECK(found.is_closed_and_oriented);
        CHECK(found.is_manifold);
        CHECK(!found.has_isolated_vertices);
        CHECK(found.genera == wanted.genera);
      }
    }
  }
}

TEST_CASE("an empty result is refused, as in one process") {
  CleanOptions options;
  options.winding_level = 2;
  CHECK_THROWS_AS(clean(test::cube(), options), GoalError);
  const test::TemporaryFolder folder;
  split(test::cube(), 2, folder);
  clean_all(2, 2, folder);
  CHECK_THROWS_AS(join(folder), GoalError);
}

TEST_CASE("missing, foreign and unequal tiles are named, and nothing is written") {
  const test::TemporaryFolder folder;
  CHECK(message_of(folder).find("has no tiles") != std::string::npos);
  const Mesh mesh = test::workload("folded", 2000, 1);
  split(mesh, 3, folder);
  CHECK(message_of(folder).find("clean-0.ply' is missing") != std::string::npos);
  clean_all(3, 1, folder);
  CHECK(message_of(folder).empty());
  std::filesystem::remove(folder / "out.ply");
  // If one tile is cleaned with another level, seams stay open.
  clean_file(folder / "tile-1.ply", folder / "clean-1.ply", 2);
  CHECK(message_of(folder).find("open") != std::string::npos);
  clean_file(folder / "tile-0.ply", folder / "clean-1.ply", 1);
  CHECK(message_of(folder).find("clean-1.ply'") != std::string::npos);
  std::filesystem::remove(folder / "clean-1.ply");
  CHECK(message_of(folder).find("tile 1 of 3") != std::string::npos);
  const test::TemporaryFolder other;
  split(test::moved(mesh, {1, 0, 0}), 3, other);
  clean_all(3, 1, other);
  std::filesystem::copy(other / "clean-1.ply", folder / "clean-1.ply");
  CHECK(message_of(folder).find("of the same mesh as the other tiles") != std::string::npos);
  CHECK(!std::filesystem::exists(folder / "out.ply"));
}
