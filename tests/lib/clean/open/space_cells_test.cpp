/// Winding numbers in cells of space, compared with solid angles, and listed by hand for walls of
/// single faces.
#include "clean/open/space_cells.h"

#include <doctest/doctest.h>

#include <set>

#include "helpers/arrangement_facts.h"
#include "mesh/disjoint_sets.h"

using namespace transformesh;

namespace {

std::vector<char> none(const Patches& patches) { return std::vector<char>(patches.size(), 0); }

/// A box that a wall of single faces divides into two rooms.
Mesh two_rooms() {
  Mesh mesh = test::cuboid({0, 0, 0}, {2, 1, 1});
  const auto base = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}});
  mesh.faces.insert(mesh.faces.end(), {{base, base + 1, base + 2}, {base, base + 2, base + 3}});
  return mesh;
}

/// Returns the patch of the piece in the plane x = 1.
Index wall_of(const Arrangement& arrangement, const Patches& patches) {
  for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
    const Triangle t = test::corners_of(arrangement, arrangement.pieces[p]);
    if (std::all_of(t.begin(), t.end(), [](const Vec3& corner) { return corner.x() == 1; }))
      return patches.patch_of[p];
  }
  return no_index;
}

bool is_connected(const Arrangement& arrangement) {
  DisjointSets sets(arrangement.point_count());
  for (const Piece& piece : arrangement.pieces)
    for (const Index corner : piece.corners) sets.join(corner, piece.corners[0]);
  const Index first = sets.find(arrangement.pieces[0].corners[0]);
  return std::all_of(arrangement.pieces.begin(), arrangement.pieces.end(),
                     [&](const Piece& piece) { return sets.find(piece.corners[0]) == first; });
}

}  // namespace

TEST_CASE("cells of intersecting closed surfaces have the winding numbers of solid angles") {
  std::size_t tested = 0, connected = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = test::random_balls(seed, 4);
    const Arrangement arrangement = test::arranged(mesh);
    // The test needs a connected arrangement, because each connected set of patches has winding
    // numbers of its own.
    if (!is_connected(arrangement)) continue;
    ++connected;
    const Patches patches(arrangement);
    const SpaceCells cells(arrangement, patches, none(patches));
    for (Index patch = 0; patch < patches.size(); ++patch) {
      for (const Index p : patches.pieces[patch]) {
        const Triangle t = test::corners_of(arrangement, arrangement.pieces[p]);
        const auto front = test::winding_beside(mesh, t, 1);
        const auto behind = test::winding_beside(mesh, t, -1);
        if (!front || !behind) continue;
        REQUIRE(cells.winding_in_front_of(patch) == *front);
        REQUIRE(cells.winding_behind(patch) == *behind);
        ++tested;
      }
    }
  }
  CHECK(connected >= 4);
  CHECK(tested > 1000);
}

TEST_CASE("a wall that occurs once has the same winding number on both sides") {
  const Arrangement arrangement = test::arranged(two_rooms());
  const Patches patches(arrangement);
  const Index wall = wall_of(arrangement, patches);
  REQUIRE(wall != no_index);
  const SpaceCells cells(arrangement, patches, none(patches));
  for (Index patch = 0; patch < patches.size(); ++patch) {
    CHECK(cells.winding_in_front_of(patch) == (patch == wall ? 1 : 0));
    CHECK(cells.winding_behind(patch) == 1);
  }
  std::vector<char> is_transparent = none(patches);
  is_transparent[wall] = 1;
  const SpaceCells united(arrangement, patches, is_transparent);
  for (Index patch = 0; patch < patches.size(); ++patch) CHECK(united.winding_behind(patch) == 1);
}

TEST_CASE("both sides of a sheet in the open are one cell, where w is 0") {
  const Arrangement arrangement = test::arranged(test::grid(3));
  const Patches patches(arrangement);
  REQUIRE(patches.size() == 1);
  const SpaceCells cells(arrangement, patches, none(patches));
  CHECK(cells.winding_in_front_of(0) == 0);
  CHECK(cells.winding_behind(0) == 0);
}

TEST_CASE("winding numbers stay right for tiny and huge coordinates") {
  for (const double scale : {1e-150, 1e150}) {
    CAPTURE(scale);
    const Mesh balls =
        test::joined(test::icosphere(2), test::moved(test::icosphere(2), {0.9, 0, 0.1}));
    const Arrangement arrangement = test::arranged(test::scaled(balls, scale));
    const Patches patches(arrangement);
    const SpaceCells cells(arrangement, patches, none(patches));
    std::multiset<int> behind;
    for (Index patch = 0; patch < patches.size(); ++patch)
      behind.insert(cells.winding_behind(patch));
    CHECK(behind == std::multiset<int>{1, 1, 2, 2});
  }
}
