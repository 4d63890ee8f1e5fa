#include "transformesh/intersect.h"

#include <doctest/doctest.h>

#include "clean/intersect/contacts.h"
#include "clean/intersect/find_meetings.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;

TEST_CASE("the search finds the pairs that testing all pairs finds") {
  for (const char* kind : {"two-spheres", "folded", "tangle", "boxes", "pinch", "torus"}) {
    CAPTURE(kind);
    Mesh mesh = test::workload(kind, 800);
    if (kind == std::string("boxes"))
      mesh = test::joined(test::joined(mesh, test::reversed(mesh)), mesh);
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
    CHECK(count_pairs(welded, find_meetings(welded, Progress())) == expected.size());
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
