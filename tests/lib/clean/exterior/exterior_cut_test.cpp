/// Tests which faces are cut along the boundary of the exterior. exterior_arrangement_test.cpp
/// compares the results with winding numbers along rays.
#include "clean/exterior/exterior_cut.h"

#include <doctest/doctest.h>

#include "clean/intersect/find_meetings.h"
#include "helpers/arrangement_facts.h"
#include "helpers/shapes.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

struct Count {
  std::size_t cut = 0;      ///< planes cut along the boundary of their exterior
  std::size_t in_full = 0;  ///< planes that have to be cut along all intersections
  std::size_t facets = 0;
};

Count cut_all(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const std::vector<Meeting> meetings = find_meetings(welded, Progress());
  const Planes planes(welded, meetings);
  const WindingJumps jumps(welded, planes);
  const RegionGrowingWinding windings(welded, planes, jumps);
  const RayCastFrontWinding ray(welded, 1);
  ExteriorCutter cutter(welded, planes, jumps, windings, ray, 1);
  Count count;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto cut = cutter.cut(planes[i]);
    ++(cut ? count.cut : count.in_full);
    if (!cut) continue;
    count.facets += cut->facets.size();
    CHECK(cut->sources.size() == cut->facets.size());
    CHECK(cut->source_offsets.size() == cut->facets.size() + 1);
  }
  return count;
}

}  // namespace

TEST_CASE("properly intersected faces are cut along the boundary of their exterior") {
  const Count count = cut_all(test::random_balls(1, 6));
  CHECK(count.in_full == 0);
  CHECK(count.cut > 100);
  CHECK(count.facets > 0);
}

TEST_CASE("a face that lies inside has no facets") {
  // Two intersecting balls inside a third one.
  const Mesh ball = test::icosphere(1);
  const Mesh mesh = test::joined(test::joined(ball, test::moved(ball, {0.5, 0.1, 0.2})),
                                 test::scaled(test::icosphere(1), 5));
  const Count count = cut_all(mesh);
  CHECK(count.in_full == 0);
  CHECK(count.cut > 20);
  CHECK(count.facets == 0);
}

TEST_CASE("coplanar faces and those that touch are cut in full") {
  const Mesh cube = test::cube();
  const Count count = cut_all(test::joined(cube, test::moved(cube, {0.5, 0, 0})));
  CHECK(count.cut == 0);
  CHECK(count.in_full > 0);
}
