/// New and vanished faces of a result, and the uncut regions of a mesh, compared with searches over
/// all pairs.
#include "clean/certify/certify_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "helpers/shapes.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

Mesh two_balls() {
  return test::joined(test::icosphere(2), test::moved(test::icosphere(2), {0.9, 0.2, 0.1}));
}

}  // namespace

TEST_CASE("faces are equal if their corners are, in the same cyclic order") {
  const Mesh mesh = test::icosphere(1);
  Mesh other = test::soup_of(mesh);  // vertex indices differ
  std::reverse(other.faces.begin(), other.faces.end());
  for (Face& face : other.faces) std::rotate(face.begin(), face.begin() + 1, face.end());
  const FaceMatch same = match_faces(mesh, other);
  CHECK(same.input_is_closed);
  CHECK(marked_faces(same.input_vanished, 1).empty());
  CHECK(marked_faces(same.output_is_new, 1).empty());

  std::swap(other.faces[4][0], other.faces[4][1]);
  double& x = other.positions[other.faces[9][0]].x();
  x = std::nextafter(x, 2);
  const FaceMatch changed = match_faces(mesh, other);
  CHECK(marked_faces(changed.output_is_new, 1) == std::vector<Index>{4, 9});
  const auto last = static_cast<Index>(mesh.faces.size() - 1);
  CHECK(marked_faces(changed.input_vanished, 1) == std::vector<Index>{last - 9, last - 4});
}

TEST_CASE("an input is closed if edges, by position, are traversed equally often both ways") {
  Mesh mesh = test::soup_of(test::cube());
  CHECK(match_faces(mesh, mesh).input_is_closed);
  CHECK(match_faces(test::joined(mesh, mesh), mesh).input_is_closed);
  mesh.faces.pop_back();
  CHECK(!match_faces(mesh, mesh).input_is_closed);
  CHECK(!match_faces(test::grid(2), mesh).input_is_closed);
}

TEST_CASE("uncut patches are connected across edges without cut faces") {
  const Mesh mesh = two_balls();
  const UncutPatches patches = find_uncut_patches(mesh, Progress());
  std::vector<char> is_cut(mesh.faces.size(), 0);
  for (const auto& [f, g] : find_intersections(mesh)) is_cut[f] = is_cut[g] = 1;
  CHECK(patches.is_cut == is_cut);

  // Two faces are neighbors if they have two common vertices.
  std::vector<Index> root(mesh.faces.size());
  std::iota(root.begin(), root.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (Index f = 0; f < root.size(); ++f) {
      for (Index g = 0; g < root.size(); ++g) {
        if (is_cut[f] || is_cut[g] || root[g] >= root[f]) continue;
        const auto& other = mesh.faces[g];
        const auto common = std::count_if(mesh.faces[f].begin(), mesh.faces[f].end(), [&](Index v) {
          return std::find(other.begin(), other.end(), v) != other.end();
        });
        if (common != 2) continue;
        root[f] = root[g];
        changed = true;
      }
    }
  }
  std::map<Index, std::vector<Index>> expected;
  for (Index f = 0; f < root.size(); ++f)
    if (!is_cut[f]) expected[root[f]].push_back(f);
  REQUIRE(patches.faces.size() == expected.size());
  CHECK(expected.size() == 4);
  std::size_t i = 0;
  for (const auto& [first, faces] : expected) CHECK(patches.faces[i++] == faces);
}

TEST_CASE("spread samples are the first and others at equal steps") {
  std::vector<Index> faces(100);
  std::iota(faces.begin(), faces.end(), 1000);
  CHECK(spread(faces, 100) == faces);
  CHECK(spread(faces, 1000) == faces);
  CHECK(spread(faces, 0).empty());
  CHECK(spread(faces, 4) == std::vector<Index>{1000, 1025, 1050, 1075});
  const std::vector<Index> some = spread(faces, 33);
  CHECK(some.size() == 33);
  for (std::size_t k = 1; k < some.size(); ++k) {
    CHECK(some[k] - some[k - 1] >= 3);
    CHECK(some[k] - some[k - 1] <= 4);
  }
  CHECK(marked_faces({0, 1, 1, 0}, 1) == std::vector<Index>{1, 2});
  CHECK(marked_faces({0, 1, 1, 0}, 0) == std::vector<Index>{0, 3});
}
