/// Changes of the winding number across a segment, for a wall and a floor with known orientation.
#include "clean/arrange/winding_jumps.h"

#include <doctest/doctest.h>

#include "clean/intersect/find_meetings.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

/// A floor that faces up, and a wall through it along the y axis that faces larger x. The wall
/// extends from `low` to `high`.
Mesh floor_and_wall(double low, double high) {
  Mesh mesh;
  mesh.positions = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, {0, -1, low}, {0, 1, low}, {0, 0, high}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  return mesh;
}

/// Returns the change of the winding number from the left to the right side of a segment. The
/// segment points to larger y, so its right side is at larger x.
int step_over_wall(const Mesh& mesh, bool reversed) {
  const WeldedMesh welded = weld(mesh);
  const std::vector<Meeting> meetings = find_meetings(welded, Progress());
  REQUIRE(meetings.size() == 1);
  const Planes planes(welded, meetings);
  const WindingJumps jumps(welded, planes);
  const ExactPoint from = ExactGeometry::free({0, -0.5, 0}), to = ExactGeometry::free({0, 0.5, 0});
  const WindingJump jump = jumps.over_segment(meetings[0], true, reversed, from, to);
  CHECK(jump.face == 1);
  CHECK(jumps.over_segment(meetings[0], true, reversed, to, from).jump == -jump.jump);
  return jump.jump;
}

Mesh with_wall_reversed(Mesh mesh) {
  std::swap(mesh.faces[1][0], mesh.faces[1][1]);
  return mesh;
}

}  // namespace

TEST_CASE("the winding number decreases towards the front of a face that rises above the plane") {
  CHECK(step_over_wall(floor_and_wall(-1, 2), false) == -1);
  CHECK(step_over_wall(with_wall_reversed(floor_and_wall(-1, 2)), false) == 1);
  CHECK(step_over_wall(floor_and_wall(0, 2), false) == -1);
  CHECK(step_over_wall(floor_and_wall(0, -2), false) == 0);
  // Seen from below, left and right are exchanged, and the part of the wall below the floor counts.
  CHECK(step_over_wall(floor_and_wall(-1, 2), true) == 1);
  CHECK(step_over_wall(floor_and_wall(0, 2), true) == 0);
}

TEST_CASE("copies of a face count, and reversed ones cancel out") {
  Mesh mesh = floor_and_wall(-1, 2);
  mesh.faces.push_back({4, 5, 3});
  CHECK(step_over_wall(mesh, false) == -2);
  mesh.faces.push_back({4, 3, 5});
  CHECK(step_over_wall(mesh, false) == -1);
}

TEST_CASE("at an edge of a face in the plane those faces count that rise from it") {
  // A floor with a fin on its first edge, a fin below the edge, and another floor beyond it. A
  // spike through the floor causes a cut.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 1}, {0.5, 0, -1}, {0.5, -1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 0, 5}, {6, 7, 8}};
  mesh.positions.insert(mesh.positions.end(), {{0.3, 0.3, -1}, {0.3, 0.4, 1}, {0.4, 0.3, 1}});
  const WeldedMesh welded = weld(mesh);
  const std::vector<Meeting> meetings = find_meetings(welded, Progress());
  const Planes planes(welded, meetings);
  const WindingJumps jumps(welded, planes);
  std::vector<WindingJump> over;
  jumps.over_edge(0, 0, 0, over);
  REQUIRE(over.size() == 1);
  CHECK(over[0].face == 1);
  // The fin traverses the edge forward, so its front is on the right.
  CHECK(over[0].jump == -1);
}
