#include "clean/exterior/exterior_cut.h"

#include <algorithm>
#include <stdexcept>

#include "clean/arrange/definition_table.h"
#include "clean/arrange/planar_triangulation.h"

namespace transformesh {
namespace {

constexpr Index first_corner = PlanarTriangulation::scaffold_points;
/// Lines 0 to 2 of the triangulation are the edges of the face; lines of segments follow.
constexpr Index edges = 3;

bool is_edge(FaceSimplex simplex) { return simplex >= edges && simplex != interior; }
bool is_corner(FaceSimplex simplex) { return simplex < edges; }

}  // namespace

/// One face, and the segments in which other faces intersect it.
class ExteriorCutter::FaceCut {
 public:
  FaceCut(const ExteriorCutter& cutter, const Plane& plane)
      : cutter_(cutter), geometry_(cutter.geometry_), face_(plane.faces[0]) {
    for (const Index v : cutter.welded_.faces[face_]) corners_.push_back(geometry_.given(v));
  }

  /// Collects the segments. Returns false if the face cannot be cut only along the boundary of its
  /// exterior part.
  bool gather(const Plane& plane);
  /// Finds points of the face at which the winding number in front is known. Returns false if there
  /// are none.
  bool find_known(std::size_t& rays);
  std::optional<PlaneCut> cut();

 private:
  bool add_segment(const Meeting& meeting);
  Index number_of(const PointDefinition& definition, Index edge);
  Index insert_end(PlanarTriangulation& triangulation, Index s, Index crossed, Index own);
  Index insert_crossing(PlanarTriangulation& triangulation, Index s, Index other);

  const ExteriorCutter& cutter_;
  const ExactGeometry& geometry_;
  Index face_;
  std::vector<ExactPoint> corners_;
  SegmentsInFace in_;
  std::vector<KnownWinding> known_;
  DefinitionTable ends_;      ///< maps definitions of segment ends to their indices in `in_.points`
  DefinitionTable inserted_;  ///< maps definitions of points to points of the triangulation
};

Index ExteriorCutter::FaceCut::number_of(const PointDefinition& definition, Index edge) {
  const Index known = ends_.find(definition);
  if (known != no_index) return known;
  const auto number = static_cast<Index>(in_.points.size());
  ends_.insert(definition, number);
  in_.points.push_back(geometry_.point(definition));
  in_.edge_of.push_back(edge);
  return number;
}

// Adds the common segment of this face and another face. Returns false if they touch instead of
// crossing, or if further faces coincide or overlap with the other face. Both faces cross if each
// end of the segment is on an edge of one face and inside the other face, or is a common corner. At
// most one end may be a common corner.
bool ExteriorCutter::FaceCut::add_segment(const Meeting& meeting) {
  const bool is_first = meeting.first == face_;
  const Index other = is_first ? meeting.second : meeting.first;
  if (meeting.contacts.count != 2 || cutter_.jumps_.multiplicity(other) != 1) return false;
  if (cutter_.planes_[cutter_.planes_.plane_of(other)].faces.size() > 1) return false;
  std::array<Index, 2> ends{};
  std::array<bool, 2> at_corner{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Contact& contact = meeting.contacts.contacts[i];
    const FaceSimplex here = is_first ? contact.first : contact.second;
    const FaceSimplex there = is_first ? contact.second : contact.first;
    at_corner[i] = is_corner(here) && is_corner(there);
    const bool crosses =
        (is_edge(here) && there == interior) || (here == interior && is_edge(there));
    if (!at_corner[i] && !crosses) return false;
    ends[i] = number_of(contact_definition(cutter_.welded_, meeting.first, meeting.second, contact),
                        here == interior ? no_index : here % edges);
  }
  if (at_corner[0] && at_corner[1]) return false;
  if (at_corner[0]) std::swap(ends[0], ends[1]);
  const WindingJump over = cutter_.jumps_.over_segment(meeting, is_first, false,
                                                       in_.points[ends[0]], in_.points[ends[1]]);
  in_.segments.push_back({ends[0], ends[1], other, over.jump});
  return over.jump == 1 || over.jump == -1;
}

bool ExteriorCutter::FaceCut::gather(const Plane& plane) {
  if (plane.faces.size() > 1 || plane.meetings.empty()) return false;
  if (cutter_.jumps_.multiplicity(face_) != 1 || cutter_.jumps_.has_open_copy(face_)) return false;
  in_.face = face_;
  in_.projection = projection_of(cutter_.welded_.triangle(face_));
  return std::all_of(plane.meetings.begin(), plane.meetings.end(),
                     [&](const Meeting* meeting) { return add_segment(*meeting); });
}

// Stores the winding numbers w that are known in front of corners of the face. If w is known at no
// corner, casts a ray at the centroid.
bool ExteriorCutter::FaceCut::find_known(std::size_t& rays) {
  for (Index i = 0; i < 3; ++i) {
    const std::optional<int> w = cutter_.windings_.at(face_, i);
    if (w) known_.push_back({corners_[i], *w, i});
  }
  if (!known_.empty()) return true;
  const ExactPoint middle = geometry_.mean(corners_[0], corners_[1], corners_[2], {1, 1, 1});
  const std::optional<int> w = cutter_.ray_.in_front_of(middle, face_);
  ++rays;
  if (w) known_.push_back({middle, *w, no_index});
  return w.has_value();
}

// Inserts an end of a part of segment `s` into the triangulation: the intersection with segment
// `crossed`, or the end point `own` of `s` if `crossed` is no_index.
Index ExteriorCutter::FaceCut::insert_end(PlanarTriangulation& triangulation, Index s,
                                          Index crossed, Index own) {
  if (crossed != no_index) return insert_crossing(triangulation, s, crossed);
  const ExactPoint& point = in_.points[own];
  const Index known = inserted_.find(point.definition), edge = in_.edge_of[own];
  if (known != no_index) {
    triangulation.add_lines(known, std::array{edges + s});
    return known;
  }
  const Index number = edge == no_index ? triangulation.insert(point, {edges + s})
                                        : triangulation.insert(point, {edge, edges + s});
  inserted_.insert(point.definition, number);
  return number;
}

Index ExteriorCutter::FaceCut::insert_crossing(PlanarTriangulation& triangulation, Index s,
                                               Index other) {
  const auto [low, high] = std::minmax(s, other);
  const Index first = in_.segments[low].face, second = in_.segments[high].face;
  const PointDefinition definition = PointDefinition::three_planes(face_, first, second);
  const Index known = inserted_.find(definition);
  if (known != no_index) return known;
  const Index number = triangulation.insert(geometry_.three_planes(face_, first, second),
                                            {edges + low, edges + high});
  inserted_.insert(definition, number);
  return number;
}

namespace {

/// Returns 1 for each exterior facet (triangle) of the face. The constrained edges separate
/// exterior from hidden facets. The facet to the left of `exterior_edge` must be exterior.
std::vector<char> find_exterior(const PlanarTriangulation& triangulation, Index exterior_edge) {
  constexpr char unknown = 2;  // a mark other than 0 (hidden) and 1 (exterior)
  const auto& facets = triangulation.facets();
  std::vector<char> is_exterior(facets.size(), unknown);
  is_exterior[exterior_edge / 3] = 1;
  std::vector<Index> stack{exterior_edge / 3};
  while (!stack.empty()) {
    const Index facet = stack.back();
    stack.pop_back();
    for (Index i = 0; i < 3; ++i) {
      bool is_border = false, is_part = false;
      triangulation.for_each_line(
          facet, i, [&](const auto& on) { (on.line < edges ? is_border : is_part) = true; });
      const Index next = facets[facet].next[i];
      if (is_border || is_exterior[next] != unknown) continue;
      is_exterior[next] = (is_exterior[facet] != 0) != is_part ? 1 : 0;
      stack.push_back(next);
    }
  }
  std::replace(is_exterior.begin(), is_exterior.end(), unknown, char{0});
  return is_exterior;
}

}  // namespace

std::optional<PlaneCut> ExteriorCutter::FaceCut::cut() {
  const auto parts = find_bounding_subsegments(geometry_, in_, known_, cutter_.winding_level_);
  if (!parts) return std::nullopt;
  if (parts->empty()) return PlaneCut{{}, {}, {0}, {}, {}};

  // The constraints are the parts of segments with exterior on exactly one side. Other parts do not
  // become edges.
  const Triangle t = cutter_.welded_.triangle(face_);
  PlanarTriangulation triangulation(geometry_, t, t[0].cwiseMin(t[1]).cwiseMin(t[2]),
                                    t[0].cwiseMax(t[1]).cwiseMax(t[2]),
                                    [](Index, Index) -> ExactPoint {
                                      throw std::logic_error("bounding subsegments do not cross");
                                    });
  if (!triangulation.begin_with_triangle({corners_[0], corners_[1], corners_[2]}))
    return std::nullopt;
  for (Index i = 0; i < 3; ++i) inserted_.insert(corners_[i].definition, first_corner + i);
  std::vector<std::array<Index, 2>> ends;
  for (const Subsegment& part : *parts) {
    const PlanarSegment& s = in_.segments[part.segment];
    ends.push_back({insert_end(triangulation, part.segment, part.from, s.from),
                    insert_end(triangulation, part.segment, part.to, s.to)});
  }
  for (std::size_t i = 0; i < ends.size(); ++i)
    triangulation.constrain(ends[i][0], ends[i][1], edges + (*parts)[i].segment);

  const Subsegment& first = parts->front();
  auto [from, to] = ends.front();
  if (!first.is_left) std::swap(from, to);
  const auto chain = triangulation.chain(from, to, {edges + first.segment, first.is_left});
  const std::vector<char> chosen = find_exterior(triangulation, chain.front());
  triangulation.improve(chosen);
  auto [points, facets, numbers] = triangulation.collect(chosen);
  PlaneCut result{std::move(points), std::move(facets), {}, {}, std::move(numbers)};
  result.sources.assign(result.facets.size(), {face_, false});
  for (Index i = 0; i <= result.facets.size(); ++i) result.source_offsets.push_back(i);
  return result;
}

std::optional<PlaneCut> ExteriorCutter::cut(const Plane& plane) {
  FaceCut face(*this, plane);
  if (!face.gather(plane) || !face.find_known(rays_)) return std::nullopt;
  return face.cut();
}

}  // namespace transformesh
