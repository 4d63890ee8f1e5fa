/// Points that are equal although their definitions differ.
#include "clean/arrange/unify_points.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "clean/intersect/find_meetings.h"
#include "helpers/shapes.h"
#include "transformesh/intersect.h"

using namespace transformesh;

TEST_CASE("equal points of all planes have one number, and different ones have two") {
  // Cubes whose edges intersect in points of a lattice. Several pairs of edges and faces define
  // each point.
  const Mesh cube = test::scaled(test::cube(), 2);
  Mesh mesh = test::joined(cube, test::moved(cube, {1, 1, 0}));
  mesh = test::joined(mesh, test::moved(cube, {1, 0, 1}));
  const WeldedMesh welded = weld(mesh);
  const std::vector<Meeting> meetings = find_meetings(welded, Progress());
  const Planes planes(welded, meetings);
  std::vector<PlaneCut> cuts;
  for (std::size_t i = 0; i < planes.size(); ++i) cuts.push_back(cut_plane(welded, planes[i]));
  const UnifiedPoints unified = unify_points(welded, cuts);

  const ExactGeometry geometry(welded.points, welded.faces);
  std::map<std::array<double, 3>, Index> id_at;
  std::set<Index> ids;
  std::size_t listed = 0;
  for (std::size_t plane = 0; plane < cuts.size(); ++plane) {
    for (std::size_t i = 0; i < cuts[plane].points.size(); ++i) {
      const Vec3 p = geometry.position(cuts[plane].points[i]);
      const Index id = unified.ids[plane][i];
      CHECK(id_at.try_emplace({p.x(), p.y(), p.z()}, id).first->second == id);
      ids.insert(id);
      ++listed;
    }
  }
  CHECK(ids.size() == id_at.size());
  CHECK(listed > 2 * ids.size());
  REQUIRE(!unified.cut_points.empty());
  CHECK(*ids.rbegin() == welded.points.size() + unified.cut_points.size() - 1);
}
