/// Planes of shapes with known coplanar faces.
#include "clean/arrange/planes.h"

#include <doctest/doctest.h>

#include "clean/intersect/find_meetings.h"
#include "helpers/shapes.h"
#include "transformesh/intersect.h"

using namespace transformesh;

TEST_CASE("coplanar faces that meet share a plane, others do not, and whole faces have none") {
  // Two cubes; the second stands on the first, shifted by 0.5 along x.
  const Mesh cube = test::cube();
  const WeldedMesh welded = weld(test::joined(cube, test::moved(cube, {0.5, 0, 1})));
  const std::vector<Meeting> meetings = find_meetings(welded, Progress());
  const Planes planes(welded, meetings);
  std::size_t coplanar = 0, whole = 0, listed = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane plane = planes[i];
    REQUIRE(!plane.faces.empty());
    CHECK(std::is_sorted(plane.faces.begin(), plane.faces.end()));
    listed += plane.faces.size();
    coplanar += plane.faces.size() > 1 ? 1 : 0;
    for (const Index face : plane.faces) CHECK(planes.plane_of(face) == i);
    for (const Meeting* meeting : plane.meetings) {
      CHECK(!meeting->contacts.coplanar);
      CHECK((planes.plane_of(meeting->first) == i || planes.plane_of(meeting->second) == i));
    }
    if (i > 0) CHECK(planes[i - 1].faces[0] < plane.faces[0]);
  }
  for (Index f = 0; f < welded.faces.size(); ++f) whole += planes.is_whole(f) ? 1 : 0;
  CHECK(listed + whole == welded.faces.size());
  CHECK(coplanar >= 1);  // the top of the first cube and the bottom of the second are coplanar
  CHECK(whole > 0);
}

TEST_CASE("of copies only the first is cut, and the others lie in its plane") {
  const Mesh ball = test::icosphere(1);
  const WeldedMesh welded = weld(test::joined(ball, test::reversed(ball)));
  const std::vector<Meeting> meetings = find_meetings(welded, Progress());
  const Planes planes(welded, meetings);
  CHECK(planes.size() == ball.faces.size());
  for (Index f = 0; f < ball.faces.size(); ++f) {
    REQUIRE(planes[f].faces.size() == 1);
    CHECK(planes[f].faces[0] == f);
    CHECK(planes.plane_of(static_cast<Index>(f + ball.faces.size())) == f);
  }
}
