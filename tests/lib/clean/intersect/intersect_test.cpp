#include "transformesh/intersect.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "clean/intersect/contacts.h"
#include "clean/intersect/find_meetings.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;

namespace {

bool is_same(const Meeting& a, const Meeting& b) {
  const auto is_equal = [](const Contact& x, const Contact& y) {
    return x.first == y.first && x.second == y.second;
  };
  return a.first == b.first && a.second == b.second && a.contacts.count == b.contacts.count &&
         std::ranges::equal(a.contacts.contacts, b.contacts.contacts, is_equal);
}

}  // namespace

TEST_CASE("the search finds the pairs that testing all pairs finds") {
  for (const char* kind : {"two-spheres", "folded", "tangle", "boxes", "pinch", "torus"}) {
    CAPTURE(kind);
    Mesh mesh = test::workload(kind, 800);
    if (kind == std::string("boxes"))
      mesh = test::joined(test::joined(mesh, test::reversed(mesh)), mesh);
    mesh.faces.insert(mesh.faces.begin(), Face{0, 0, 1});
    const WeldedMesh welded = weld(mesh);
    std::vector<FacePair> expected;
    for (Index f = 0; f < welded.faces.size(); ++f) {
      for (Index g = f + 1; g < welded.faces.size(); ++g) {
        if (find_contacts(welded, f, g).meet) {
          expected.emplace_back(welded.face_of[f], welded.face_of[g]);
        }
      }
    }
    CHECK(find_intersections(mesh) == expected);
    const std::vector<Meeting> found = find_meetings(welded, Progress());
    CHECK(count_pairs(welded, found) == expected.size());
    CHECK(std::ranges::equal(meetings_of(welded, expected), found, is_same));
    const ThreadLimit limit(1);
    CHECK(find_intersections(mesh) == expected);
  }
}

TEST_CASE("segments of two balls lie on both") {
  const Vec3 center(0.9, 0.21, 0.13);
  const Mesh mesh = test::joined(test::icosphere(4), test::moved(test::icosphere(4), center));
  const auto pairs = find_intersections(mesh);
  const auto segments = intersection_segments(mesh, pairs);
  REQUIRE(segments.size() == pairs.size());
  for (const auto& [a, b] : segments) {
    CHECK(a.norm() == doctest::Approx(1).epsilon(0.01));
    CHECK((b - center).norm() == doctest::Approx(1).epsilon(0.01));
  }
}
