#include "clean/arrange/winding_jumps.h"

#include <algorithm>

#include "mesh/corners.h"
#include "support/numbered_selection.h"

namespace transformesh {
namespace {

bool has_same_direction(const Face& face, const Face& copy) {
  const auto at =
      static_cast<std::size_t>(std::find(copy.begin(), copy.end(), face[0]) - copy.begin());
  return copy[(at + 1) % 3] == face[1];
}

// Finds a coordinate in which two points differ, and stores its index in `coordinate`. Returns the
// sign of `to` minus `from` in this coordinate, or 0 if the points are equal.
int direction(const ExactGeometry& geometry, const ExactPoint& from, const ExactPoint& to,
              int& coordinate) {
  (to.center - from.center).cwiseAbs().maxCoeff(&coordinate);
  for (int i = 0; i < 3; ++i) {
    const int sign = geometry.compare_coordinate(to, from, coordinate);
    if (sign != 0) return sign;
    coordinate = (coordinate + 1) % 3;
  }
  return 0;
}

}  // namespace

WindingJumps::WindingJumps(const WeldedMesh& welded, const Planes& planes)
    : welded_(welded), planes_(planes) {
  list_singular_edges();
  if (welded_.has_copies || !welded_.open_component.empty()) count_copies();
}

void WindingJumps::list_singular_edges() {
  const Edges& edges = welded_.edges;
  const NumberedSelection singular(edges.size(), [&](std::size_t e) {
    return welded_.opposites[edges.halfedges(e).front()] == no_index;
  });
  for (const Index e : singular.list())
    for (const Index h : edges.halfedges(e)) singular_edge_of_.emplace_back(h, e);
  std::sort(singular_edge_of_.begin(), singular_edge_of_.end());
}

template <class Visit>
void WindingJumps::for_each_at_edge(Index halfedge, const Visit& visit) const {
  const Index opposite = welded_.opposites[halfedge];
  if (opposite != no_index) {
    visit(std::min(halfedge, opposite));
    visit(std::max(halfedge, opposite));
    return;
  }
  const auto found = std::lower_bound(singular_edge_of_.begin(), singular_edge_of_.end(),
                                      std::pair(halfedge, Index{0}));
  for (const Index h : welded_.edges.halfedges(found->second)) visit(h);
}

void WindingJumps::count_copies() {
  multiplicities_.assign(welded_.faces.size(), 0);
  if (!welded_.open_component.empty()) has_open_copy_.assign(welded_.faces.size(), 0);
  bool count_once = true;
  for (Index f = 0; f < welded_.faces.size(); ++f) {
    const Index first = welded_.first_copy[f];
    count_once &= first == f && !welded_.is_open(f);
    if (welded_.is_open(f)) {
      has_open_copy_[first] = 1;
    } else {
      multiplicities_[first] += has_same_direction(welded_.faces[first], welded_.faces[f]) ? 1 : -1;
    }
  }
  if (count_once) multiplicities_.clear();
}

// Let n be the normal of the face beside which the jump is measured, and m the normal of the other
// face. Then n x m is parallel to the segment. Points to the left of n x m are behind the other
// face.
WindingJump WindingJumps::over_segment(const Meeting& meeting, bool seen_from_first, bool reversed,
                                       const ExactPoint& from, const ExactPoint& to) const {
  const Contacts& contacts = meeting.contacts;
  const Index here = seen_from_first ? meeting.first : meeting.second;
  const Index other = seen_from_first ? meeting.second : meeting.first;
  const auto& sides = seen_from_first ? contacts.second_sides : contacts.first_sides;
  const int front = reversed ? -1 : 1;
  const bool reaches_front =
      std::any_of(sides.begin(), sides.end(), [&](int side) { return side * front > 0; });
  if (!reaches_front) return {other, 0};
  int coordinate = 0;
  const int along = direction({welded_.points, welded_.faces}, from, to, coordinate);
  const int sine =
      front * normals_cross(welded_.triangle(here), welded_.triangle(other), coordinate);
  return {other, -along * sine * multiplicity(other)};
}

void WindingJumps::over_edge(Index face, Index i, Index plane,
                             std::vector<WindingJump>& jumps) const {
  const Index from = welded_.faces[face][i];
  const Triangle t = welded_.triangle(plane);
  for_each_at_edge(3 * face + i, [&](Index h) {
    const Index other = h / 3;
    if (welded_.first_copy[other] != other) return;
    if (planes_.plane_of(other) == planes_.plane_of(plane)) return;
    const Face& corners = welded_.faces[other];
    const Vec3& apex = welded_.points[corners[next_corner(next_corner(h % 3))]];
    if (orient3d(t[0], t[1], t[2], apex) <= 0) return;
    const int along = corners[h % 3] == from ? 1 : -1;
    jumps.push_back({other, -along * multiplicity(other)});
  });
}

}  // namespace transformesh
