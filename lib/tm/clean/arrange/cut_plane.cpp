#include "tm/clean/arrange/cut_plane.h"

#include <algorithm>

#include "tm/clean/arrange/planar_triangulation.h"

namespace transformesh {
namespace {

// What a constraint lies on: an edge in the plane, or the plane of a face that crosses it.
struct Line {
  bool is_edge;
  Index a;  ///< the start of the edge, or the face that crosses
  Index b;  ///< the end of the edge
};

struct Segment {
  Index from;
  Index to;
  Index line;
};

class PlaneCutter {
 public:
  PlaneCutter(const WeldedMesh& welded, const std::vector<Index>& faces,
              const std::vector<const Meeting*>& meetings);
  PlaneCut cut();

 private:
  std::array<Vec3, 2> box() const;
  ExactPoint crossing(Index first_line, Index second_line) const;
  void insert_faces();
  void insert_meeting(const Meeting& meeting);
  Index edge_line(Index face, FaceSimplex simplex) const;
  void flood(std::size_t k, std::vector<std::vector<PieceSource>>& covers);
  PlaneCut collect(const std::vector<std::vector<PieceSource>>& covers) const;

  const WeldedMesh& welded_;
  const std::vector<Index>& faces_;
  const std::vector<const Meeting*>& meetings_;
  ExactGeometry geometry_;
  PlaneProjection projection_;
  std::vector<Line> lines_;  ///< of the three edges of each face, then of each meeting
  std::vector<Segment> segments_;
  std::vector<std::array<Index, 3>> corners_;  ///< of each face
  PlanarTriangulation triangulation_;
  std::vector<Index> border_stamp_;  ///< per edge: k + 1 of the last face k that it bounds, or 0
};

PlaneCutter::PlaneCutter(const WeldedMesh& welded, const std::vector<Index>& faces,
                         const std::vector<const Meeting*>& meetings)
    : welded_(welded),
      faces_(faces),
      meetings_(meetings),
      geometry_(welded.points, welded.faces),
      projection_(projection_of(welded.triangle(faces[0]))),
      triangulation_(geometry_, welded.triangle(faces[0]), box()[0], box()[1],
                     [this](Index a, Index b) { return crossing(a, b); }) {}

std::array<Vec3, 2> PlaneCutter::box() const {
  Vec3 low = welded_.points[welded_.faces[faces_[0]][0]];
  Vec3 high = low;
  for (const Index face : faces_) {
    for (const Vec3& p : welded_.triangle(face)) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return {low, high};
}

ExactPoint PlaneCutter::crossing(Index first_line, Index second_line) const {
  const Line& p = lines_[first_line];
  const Line& q = lines_[second_line];
  if (p.is_edge && q.is_edge) return geometry_.line_line(p.a, p.b, q.a, q.b);
  if (p.is_edge) return geometry_.line_plane(p.a, p.b, q.a);
  if (q.is_edge) return geometry_.line_plane(q.a, q.b, p.a);
  return geometry_.three_planes(faces_[0], p.a, q.a);
}

void PlaneCutter::insert_faces() {
  for (const Index face : faces_) {
    const Face& corners = welded_.faces[face];
    std::array<Index, 3> local{};
    const auto line = static_cast<Index>(lines_.size());
    for (std::size_t i = 0; i < 3; ++i) {
      lines_.push_back({true, corners[i], corners[(i + 1) % 3]});
    }
    for (Index i = 0; i < 3; ++i) {
      local[i] = triangulation_.insert(geometry_.given(corners[i]), {line + i, line + (i + 2) % 3});
    }
    corners_.push_back(local);
    for (Index i = 0; i < 3; ++i) {
      segments_.push_back({local[i], local[(i + 1) % 3], line + i});
    }
  }
}

// The line of a simplex of a face in this plane, where that is an edge; else no_index.
Index PlaneCutter::edge_line(Index face, FaceSimplex simplex) const {
  if (simplex < 3 || simplex == interior) return no_index;
  const auto k = std::lower_bound(faces_.begin(), faces_.end(), face) - faces_.begin();
  return static_cast<Index>(3 * k + simplex - 3);
}

void PlaneCutter::insert_meeting(const Meeting& meeting) {
  const bool first_is_here = std::binary_search(faces_.begin(), faces_.end(), meeting.first);
  const Index here = first_is_here ? meeting.first : meeting.second;
  const Index other = first_is_here ? meeting.second : meeting.first;
  const auto line = static_cast<Index>(lines_.size());
  lines_.push_back({false, other, 0});

  std::array<Index, 2> ends{};
  for (int i = 0; i < meeting.contacts.count; ++i) {
    const Contact contact = meeting.contacts.contacts[static_cast<std::size_t>(i)];
    const ExactPoint point =
        contact_point(welded_, geometry_, meeting.first, meeting.second, contact);
    const Index edge = edge_line(here, first_is_here ? contact.first : contact.second);
    const Index local = edge == no_index ? triangulation_.insert(point, {line})
                                         : triangulation_.insert(point, {line, edge});
    ends[i == 0 ? 0 : 1] = local;
  }
  if (meeting.contacts.count > 1) segments_.push_back({ends[0], ends[1], line});
}

// Names the k-th face as a source of all facets that its border encloses.
void PlaneCutter::flood(std::size_t k, std::vector<std::vector<PieceSource>>& covers) {
  const std::array<Index, 3>& corner = corners_[k];
  const auto& facets = triangulation_.facets();
  const bool reversed = orient2d(welded_.triangle(faces_[k])[0], welded_.triangle(faces_[k])[1],
                                 welded_.triangle(faces_[k])[2], projection_) < 0;
  const auto stamp = static_cast<Index>(k + 1);
  std::vector<Index> stack;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index from = corner[i], to = corner[(i + 1) % 3];
    // The chain runs so that the face lies on its left.
    for (const Index edge :
         reversed ? triangulation_.chain(to, from) : triangulation_.chain(from, to)) {
      border_stamp_[edge] = stamp;
      stack.push_back(edge / 3);
    }
  }
  while (!stack.empty()) {
    const Index facet = stack.back();
    stack.pop_back();
    if (!covers[facet].empty() && covers[facet].back().face == faces_[k]) continue;
    covers[facet].push_back({faces_[k], reversed});
    for (Index i = 0; i < 3; ++i) {
      if (border_stamp_[3 * facet + i] != stamp) stack.push_back(facets[facet].next[i]);
    }
  }
}

PlaneCut PlaneCutter::collect(const std::vector<std::vector<PieceSource>>& covers) const {
  PlaneCut result;
  for (Index i = 0; i < triangulation_.point_count(); ++i) {
    result.points.push_back(triangulation_.point(i));
  }
  result.source_offsets.push_back(0);
  for (std::size_t i = 0; i < covers.size(); ++i) {
    if (covers[i].empty()) continue;
    result.facets.push_back(triangulation_.facets()[i].v);
    result.sources.insert(result.sources.end(), covers[i].begin(), covers[i].end());
    result.source_offsets.push_back(static_cast<Index>(result.sources.size()));
  }
  return result;
}

PlaneCut PlaneCutter::cut() {
  insert_faces();
  for (const Meeting* meeting : meetings_) insert_meeting(*meeting);
  for (const Segment& segment : segments_) {
    triangulation_.constrain(segment.from, segment.to, segment.line);
  }
  triangulation_.improve();

  std::vector<std::vector<PieceSource>> covers(triangulation_.facets().size());
  border_stamp_.assign(3 * covers.size(), 0);
  for (std::size_t k = 0; k < faces_.size(); ++k) flood(k, covers);
  return collect(covers);
}

}  // namespace

PlaneCut cut_plane(const WeldedMesh& welded, const std::vector<Index>& faces,
                   const std::vector<const Meeting*>& meetings) {
  return PlaneCutter(welded, faces, meetings).cut();
}

}  // namespace transformesh
