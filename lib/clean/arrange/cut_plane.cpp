#include "clean/arrange/cut_plane.h"

#include <algorithm>
#include <optional>

#include "clean/arrange/definition_table.h"
#include "clean/arrange/planar_triangulation.h"
#include "mesh/corners.h"

namespace transformesh {
namespace {

// Source of constraints of the triangulation: an edge of a face in the plane, or a face that
// intersects the plane.
struct Line {
  bool is_edge;
  Index a;  ///< start of the edge, or the intersecting face
  Index b;  ///< end of the edge
  /// Change of the winding number across the segment of an intersecting face.
  WindingJump jump{no_index, 0};
  std::optional<ExactPlane> plane{};  ///< plane of the intersecting face, computed on demand
};

struct Segment {
  Index from;
  Index to;
  Index line;
};

class PlaneCutter : public PlaneFacets {
 public:
  PlaneCutter(const WeldedMesh& welded, const Plane& plane, const WindingJumps* jumps);
  void cut();
  PlaneCut collect(const std::vector<char>& chosen);
  std::vector<char> all_covered() const;

  std::size_t size() const override { return triangulation_.facets().size(); }
  bool is_covered(Index facet) const override { return !covers_[facet].empty(); }
  int multiplicity(Index facet) const override;
  bool has_open_face(Index facet) const override;
  Index neighbor(Index facet, Index i) const override {
    return triangulation_.facets()[facet].next[i];
  }
  int jump(Index facet, Index i) const override;
  std::array<ExactPoint, 3> corners(Index facet) const override;
  Index facet_at_corner(Index i) const override { return corner_facets_[i]; }

 private:
  using Cover = boost::container::small_vector<PieceSource, 1>;

  std::array<Vec3, 2> box() const;
  ExactPoint crossing(Index first_line, Index second_line) const;
  const ExactPlane* plane_through(Index line);
  void insert_faces();
  bool insert_only_face();
  void insert_meeting(const Meeting& meeting);
  Index edge_line(Index face, FaceSimplex simplex) const;
  void flood(std::size_t k);
  int step_of_faces(Index facet, Index i) const;

  const WeldedMesh& welded_;
  const Plane& plane_;
  const WindingJumps* jumps_;  ///< null unless pieces are chosen by winding numbers
  ExactGeometry geometry_;
  PlaneProjection projection_;
  /// Sources of constraints: three for the edges of each face, then one for each intersecting face.
  std::vector<Line> lines_;
  std::vector<Segment> segments_;
  std::vector<std::array<Index, 3>> corners_;  ///< triangulation points of the corners of each face
  /// 1 for each face in the plane whose orientation is opposite to that of the first face.
  std::vector<char> is_reversed_;
  PlanarTriangulation triangulation_;
  DefinitionTable known_points_;
  /// For each edge of a facet: 1 + the index in the plane of the last face whose boundary contains
  /// the edge, or 0 if there is none.
  std::vector<Index> border_stamp_;
  std::vector<Cover> covers_;  ///< faces that contain each facet
  std::array<Index, 3> corner_facets_{};
};

PlaneCutter::PlaneCutter(const WeldedMesh& welded, const Plane& plane, const WindingJumps* jumps)
    : welded_(welded),
      plane_(plane),
      jumps_(jumps),
      geometry_(welded.points, welded.faces),
      projection_(projection_of(welded.triangle(plane.faces[0]))),
      triangulation_(
          geometry_, welded.triangle(plane.faces[0]), box()[0], box()[1],
          [this](Index a, Index b) { return crossing(a, b); },
          [this](Index line) { return plane_through(line); }) {
  for (const Index face : plane.faces) {
    const Triangle t = welded.triangle(face);
    is_reversed_.push_back(orient2d(t[0], t[1], t[2], projection_) < 0 ? 1 : 0);
  }
}

std::array<Vec3, 2> PlaneCutter::box() const {
  Vec3 low = welded_.points[welded_.faces[plane_.faces[0]][0]];
  Vec3 high = low;
  for (const Index face : plane_.faces) {
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
  if (p.is_edge && q.is_edge)
    return geometry_.point(PointDefinition::line_line(p.a, p.b, q.a, q.b));
  if (p.is_edge) return geometry_.point(PointDefinition::line_plane(p.a, p.b, q.a));
  if (q.is_edge) return geometry_.point(PointDefinition::line_plane(q.a, q.b, p.a));
  return geometry_.three_planes(plane_.faces[0], p.a, q.a);
}

const ExactPlane* PlaneCutter::plane_through(Index line) {
  Line& of = lines_[line];
  if (of.is_edge) return nullptr;
  if (!of.plane) of.plane = geometry_.plane(of.a);
  return &*of.plane;
}

void PlaneCutter::insert_faces() {
  for (const Index face : plane_.faces) {
    const Face& v = welded_.faces[face];
    for (Index i = 0; i < 3; ++i) lines_.push_back({true, v[i], v[next_corner(i)]});
  }
  if (plane_.faces.size() == 1 && insert_only_face()) return;
  for (Index k = 0; k < plane_.faces.size(); ++k) {
    const Face& v = welded_.faces[plane_.faces[k]];
    std::array<Index, 3> local{};
    for (Index i = 0; i < 3; ++i) {
      const PointDefinition definition = PointDefinition::given(v[i]);
      local[i] =
          triangulation_.insert(geometry_.point(definition), {3 * k + i, 3 * k + (i + 2) % 3});
      known_points_.insert(definition, local[i]);
    }
    corners_.push_back(local);
    for (Index i = 0; i < 3; ++i) segments_.push_back({local[i], local[next_corner(i)], 3 * k + i});
  }
}

bool PlaneCutter::insert_only_face() {
  const Face& v = welded_.faces[plane_.faces[0]];
  if (!triangulation_.begin_with_triangle(
          {geometry_.given(v[0]), geometry_.given(v[1]), geometry_.given(v[2])}))
    return false;
  corners_.push_back({3, 4, 5});
  for (Index i = 0; i < 3; ++i) known_points_.insert(PointDefinition::given(v[i]), corners_[0][i]);
  return true;
}

// Returns the index in `lines_` of an edge of a face in this plane, or no_index if `simplex` is a
// corner or the interior of the face.
Index PlaneCutter::edge_line(Index face, FaceSimplex simplex) const {
  if (simplex < 3 || simplex == interior) return no_index;
  const auto& faces = plane_.faces;
  const auto k = std::lower_bound(faces.begin(), faces.end(), face) - faces.begin();
  return static_cast<Index>(3 * k + simplex - 3);
}

void PlaneCutter::insert_meeting(const Meeting& meeting) {
  const auto at = std::lower_bound(plane_.faces.begin(), plane_.faces.end(), meeting.first);
  const bool first_is_here = at != plane_.faces.end() && *at == meeting.first;
  const Index here = first_is_here ? meeting.first : meeting.second;
  const Index other = first_is_here ? meeting.second : meeting.first;
  const auto line = static_cast<Index>(lines_.size());
  lines_.push_back({false, other, 0});

  std::array<Index, 2> ends{};
  for (int i = 0; i < meeting.contacts.count; ++i) {
    const Contact contact = meeting.contacts.contacts[static_cast<std::size_t>(i)];
    const PointDefinition definition =
        contact_definition(welded_, meeting.first, meeting.second, contact);
    const Index edge = edge_line(here, first_is_here ? contact.first : contact.second);
    const std::array<Index, 2> on{edge == no_index ? line : std::min(edge, line),
                                  std::max(edge, line)};
    const std::span<const Index> lines(on.data(), edge == no_index ? 1 : 2);
    Index local = known_points_.find(definition);
    if (local == no_index) {
      local = triangulation_.insert(geometry_.point(definition), lines);
      known_points_.insert(definition, local);
    } else {
      triangulation_.add_lines(local, lines);
    }
    ends[i == 0 ? 0 : 1] = local;
  }
  if (meeting.contacts.count < 2) return;
  segments_.push_back({ends[0], ends[1], line});
  if (jumps_ == nullptr) return;
  const auto k = std::lower_bound(plane_.faces.begin(), plane_.faces.end(), here);
  lines_[line].jump =
      jumps_->over_segment(meeting, first_is_here, is_reversed_[k - plane_.faces.begin()] != 0,
                           triangulation_.point(ends[0]), triangulation_.point(ends[1]));
}

// Records, for each facet (triangle of the cut plane) inside face `k`, that this face covers it.
void PlaneCutter::flood(std::size_t k) {
  const std::array<Index, 3>& corner = corners_[k];
  const auto& facets = triangulation_.facets();
  const bool reversed = is_reversed_[k] != 0;
  const auto stamp = static_cast<Index>(k + 1);
  std::vector<Index> stack;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index from = corner[i], to = corner[(i + 1) % 3];
    // Find the triangulation edges along edge `i` of the face, in the direction in which the face
    // is on their left.
    const auto line = static_cast<Index>(3 * k + i);
    for (const Index edge : reversed ? triangulation_.chain(to, from, {line, false})
                                     : triangulation_.chain(from, to, {line, true})) {
      border_stamp_[edge] = stamp;
      stack.push_back(edge / 3);
      if (k == 0 && triangulation_.source(edge) == from) corner_facets_[i] = edge / 3;
    }
  }
  while (!stack.empty()) {
    const Index facet = stack.back();
    stack.pop_back();
    Cover& cover = covers_[facet];
    if (!cover.empty() && cover.back().face == plane_.faces[k]) continue;
    cover.push_back({plane_.faces[k], reversed});
    for (Index i = 0; i < 3; ++i) {
      if (border_stamp_[3 * facet + i] != stamp) stack.push_back(facets[facet].next[i]);
    }
  }
}

void PlaneCutter::cut() {
  insert_faces();
  for (const Meeting* meeting : plane_.meetings) insert_meeting(*meeting);
  for (const Segment& segment : segments_)
    triangulation_.constrain(segment.from, segment.to, segment.line);
  covers_.resize(triangulation_.facets().size());
  border_stamp_.assign(3 * covers_.size(), 0);
  for (std::size_t k = 0; k < plane_.faces.size(); ++k) flood(k);
}

int PlaneCutter::multiplicity(Index facet) const {
  int sum = 0;
  for (const PieceSource& source : covers_[facet]) {
    const int copies = jumps_ == nullptr ? 1 : jumps_->multiplicity(source.face);
    sum += source.reversed ? -copies : copies;
  }
  return sum;
}

bool PlaneCutter::has_open_face(Index facet) const {
  return std::any_of(covers_[facet].begin(), covers_[facet].end(),
                     [&](const PieceSource& source) { return jumps_->has_open_copy(source.face); });
}

int PlaneCutter::jump(Index facet, Index i) const {
  const Index first = triangulation_.facets()[facet].line[i];
  if (first == no_index) return 0;
  if (plane_.faces.size() > 1) return step_of_faces(facet, i);
  int sum = 0;
  triangulation_.for_each_line(facet, i, [&](const auto& on) {
    const int jump = lines_[on.line].jump.jump;
    sum += on.is_along ? jump : -jump;
  });
  return sum;
}

// Returns the change of the winding number across edge `i` of a facet, if the plane has several
// faces. Then the edge may be on several segments of the same intersecting face; each intersecting
// face counts once.
int PlaneCutter::step_of_faces(Index facet, Index i) const {
  std::vector<WindingJump> jumps;
  triangulation_.for_each_line(facet, i, [&](const auto& on) {
    const std::size_t before = jumps.size();
    if (lines_[on.line].is_edge) {
      jumps_->over_edge(plane_.faces[on.line / 3], on.line % 3, plane_.faces[0], jumps);
    } else {
      jumps.push_back(lines_[on.line].jump);
    }
    for (std::size_t s = before; s < jumps.size() && !on.is_along; ++s)
      jumps[s].jump = -jumps[s].jump;
  });
  std::sort(jumps.begin(), jumps.end(),
            [](const auto& a, const auto& b) { return a.face < b.face; });
  int sum = 0;
  for (std::size_t s = 0; s < jumps.size(); ++s)
    if (s == 0 || jumps[s].face != jumps[s - 1].face) sum += jumps[s].jump;
  return sum;
}

std::array<ExactPoint, 3> PlaneCutter::corners(Index facet) const {
  const auto& [a, b, c] = triangulation_.facets()[facet].v;
  return {triangulation_.point(a), triangulation_.point(b), triangulation_.point(c)};
}

std::vector<char> PlaneCutter::all_covered() const {
  std::vector<char> chosen;
  for (const Cover& cover : covers_) chosen.push_back(cover.empty() ? 0 : 1);
  return chosen;
}

// Flips edges until the chosen facets are constrained Delaunay, and returns them. No constrained
// edge is flipped, so `covers_` stays valid.
PlaneCut PlaneCutter::collect(const std::vector<char>& chosen) {
  triangulation_.improve(chosen);
  auto [points, facets, numbers] = triangulation_.collect(chosen);
  PlaneCut result{std::move(points), std::move(facets), {0}, {}, {}};
  for (const Index facet : numbers) {
    result.sources.insert(result.sources.end(), covers_[facet].begin(), covers_[facet].end());
    result.source_offsets.push_back(static_cast<Index>(result.sources.size()));
  }
  result.numbers = std::move(numbers);
  return result;
}

}  // namespace

PlaneCut cut_plane(const WeldedMesh& welded, const Plane& plane) {
  PlaneCutter cutter(welded, plane, nullptr);
  cutter.cut();
  return cutter.collect(cutter.all_covered());
}

PlaneCut cut_plane(const WeldedMesh& welded, const Plane& plane, const WindingJumps& jumps,
                   const ChooseFacets& choose) {
  PlaneCutter cutter(welded, plane, &jumps);
  cutter.cut();
  return cutter.collect(choose(cutter));
}

}  // namespace transformesh
