#include "clean/intersect/faces_to_search.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "clean/intersect/contacts.h"
#include "clean/intersect/intersection_free_regions.h"
#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"

// The oracle is the exact test of two faces.
using namespace transformesh;

namespace {

/// Returns the number of faces to search. Checks that all other faces have no intersection.
std::size_t count_to_search(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const RawVector<Index> faces =
      find_faces_to_search(welded, find_intersection_free_regions(welded).of_face);
  CHECK(std::is_sorted(faces.begin(), faces.end()));
  std::size_t meetings = 0;
  std::vector<char> is_searched(welded.faces.size(), 0);
  for (const Index f : faces) is_searched[f] = 1;
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (is_searched[f] || welded.first_copy[f] != f) continue;
    for (Index g = 0; g < welded.faces.size(); ++g)
      meetings += f != g && find_contacts(welded, f, g).meet ? 1 : 0;
  }
  CHECK(meetings == 0);
  return faces.size();
}

TEST_CASE("of a smooth surface few faces need be searched") {
  const Mesh sphere = test::icosphere(4);
  CHECK(count_to_search(sphere) < sphere.faces.size() / 2);
}

TEST_CASE("two intersecting balls are searched only near their intersection") {
  const Mesh balls =
      test::joined(test::icosphere(3), test::moved(test::icosphere(3), Vec3(1.7, 0.1, 0.05)));
  CHECK(count_to_search(balls) > 0);
  CHECK(count_to_search(balls) < balls.faces.size());
}

TEST_CASE("whatever the surface, faces that are left out meet nothing") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    test::Random random(seed);
    for (const double noise : {0.02, 0.1, 0.4}) {
      Mesh mesh = test::icosphere(2);
      for (Vec3& p : mesh.positions) p += random.point(-noise, noise);
      count_to_search(mesh);
    }
  }
  for (const char* kind : {"two-spheres", "folded", "tangle", "boxes", "pinch"})
    count_to_search(test::workload(kind, 800));
}

TEST_CASE("meshes of any size are searched, and those that one face spans") {
  for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
    Mesh mesh = test::icosphere(2);
    for (Vec3& p : mesh.positions) p *= scale;
    CHECK(count_to_search(mesh) > 0);
  }
  Mesh spanned = test::icosphere(3);
  const auto first = static_cast<Index>(spanned.positions.size());
  for (const Vec3& p : {Vec3(-90, -90, 0.5), Vec3(90, -90, 0.5), Vec3(0, 90, 0.5)})
    spanned.positions.push_back(p);
  spanned.faces.push_back({first, first + 1, first + 2});
  count_to_search(spanned);
}

}  // namespace
