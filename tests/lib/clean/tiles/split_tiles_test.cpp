/// Tiles, compared with the mesh from which they are split.
#include "clean/tiles/split_tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "clean/box/box_submesh.h"
#include "clean/box/tile.h"
#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

namespace {

SplitResult split(const std::string& path, std::size_t count, const std::string& folder) {
  SplitResult result = split_tiles(PlyRows(path), count, folder, Progress());
  for (AtomicFile& file : result.files) file.commit();
  return result;
}

/// A mesh that covers points up to three times, with a column of face numbers and an unused vertex.
Mesh numbered_mesh() {
  const Mesh once = test::workload("folded", 3000, 1);
  Mesh mesh = test::joined(test::joined(once, once), test::workload("many-spheres", 2000, 4));
  mesh.positions.insert(mesh.positions.begin(), Vec3(50, 50, 50));
  for (Face& face : mesh.faces)
    for (Index& v : face) ++v;
  Column& number = mesh.face_columns.get("number", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) number.values[f] = static_cast<double>(f);
  return mesh;
}

/// Returns the faces and `rings` rings of faces around them, connected by common positions.
std::vector<bool> with_rings(const Mesh& mesh, std::vector<bool> faces, int rings) {
  const auto key = [](const Vec3& p) { return std::array{p.x(), p.y(), p.z()}; };
  for (int ring = 0; ring < rings; ++ring) {
    std::set<std::array<double, 3>> places;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const Index v : mesh.faces[f])
        if (faces[f]) places.insert(key(mesh.positions[v]));
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const Index v : mesh.faces[f])
        if (places.contains(key(mesh.positions[v]))) faces[f] = true;
  }
  return faces;
}

}  // namespace

TEST_CASE(
    "a tile has the faces around its own ones, and all in its box, and a true winding number") {
  const test::TemporaryFolder folder;
  const Mesh mesh = numbered_mesh();
  write_mesh_file(folder / "in.ply", mesh);
  int largest = 0;
  for (const std::size_t count : {1, 7, 12}) {
    const SplitResult result = split(folder / "in.ply", count, folder / "");
    CHECK(result.faces == mesh.faces.size());
    REQUIRE(result.files.size() == count);
    std::vector<int> owners(mesh.faces.size(), 0);
    std::size_t sum = 0;
    for (std::size_t t = 0; t < count; ++t) {
      const Document document =
          read_mesh(test::content_of(tile_path(folder / "", t, count)), "tile").document;
      const auto tile = tile_of(document.style.comments);
      REQUIRE(tile);
      CHECK(tile->name == TileName{face_sums(mesh).hash(), t, count});
      CHECK(tile->faces == face_sums(document.mesh).hash());
      CHECK(tile->held.contains(tile->reference.position));
      CHECK(tile->reference.winding ==
            std::lround(test::winding_number(mesh, tile->reference.position)));
      largest = std::max(largest, tile->reference.winding);
      const std::vector<double>& numbers = document.mesh.face_columns.find("number")->values;
      CHECK(std::is_sorted(numbers.begin(), numbers.end()));
      sum += numbers.size();
      const std::vector<bool> own = faces_of_box(mesh, tile->own);
      const std::vector<bool> rings = with_rings(mesh, own, 4);
      const std::vector<bool> touches = faces_near(mesh, tile->held);
      for (std::size_t f = 0; f < rings.size(); ++f)
        if (rings[f] || touches[f])
          CHECK(std::binary_search(numbers.begin(), numbers.end(), static_cast<double>(f)));
      for (std::size_t f = 0; f < own.size(); ++f) {
        owners[f] += own[f] ? 1 : 0;
      }
    }
    CHECK(std::all_of(owners.begin(), owners.end(), [](int n) { return n == 1; }));
    CHECK(result.tile_faces == sum);
  }
  CHECK(largest > 1);
}

TEST_CASE("open meshes, and meshes without faces, are refused") {
  const test::TemporaryFolder folder;
  Mesh mesh = test::icosphere(2);
  std::swap(mesh.faces[3][0], mesh.faces[3][1]);
  write_mesh_file(folder / "turned.ply", mesh);
  CHECK_THROWS_AS(split(folder / "turned.ply", 2, folder / ""), InputError);
  mesh.faces.erase(mesh.faces.begin() + 3);
  write_mesh_file(folder / "open.ply", mesh);
  CHECK_THROWS_AS(split(folder / "open.ply", 2, folder / ""), InputError);
  mesh.faces.clear();
  write_mesh_file(folder / "none.ply", mesh);
  CHECK_THROWS_AS(split(folder / "none.ply", 2, folder / ""), InputError);
  CHECK(folder.count() == 3);
}

TEST_CASE("more tiles than faces leave some empty") {
  const test::TemporaryFolder folder;
  write_mesh_file(folder / "in.ply", test::tetrahedron());
  const SplitResult result = split(folder / "in.ply", 10, folder / "");
  CHECK(result.files.size() == 10);
  CHECK(result.empty_tiles >= 6);
  CHECK(tile_path("a", 7, 10) == "a/tile-7.ply");
  CHECK(tile_path("a", 7, 11) == "a/tile-07.ply");
}
