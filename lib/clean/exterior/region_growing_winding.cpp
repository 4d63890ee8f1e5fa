#include "clean/exterior/region_growing_winding.h"

#include <algorithm>

#include "clean/arrange/cut_plane.h"
#include "mesh/corners.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t planes_per_task = 256;  ///< affects time only
/// Up to this number of rays, testing all faces costs less than building a hierarchy. After the
/// first `few` rays, `many` are expected. Both are choices and affect only the time.
constexpr std::size_t few = 8;
constexpr std::size_t many = 1000;

/// Returns for each halfedge its opposite halfedge, if the edge has exactly two faces with opposite
/// directions.
std::vector<Index> oriented_neighbors(const WeldedMesh& welded, const Edges& edges) {
  std::vector<Index> across = neighbors_across(edges, welded.faces.size());
  for (Index h = 0; h < across.size(); ++h) {
    const Index other = across[h];
    if (other != no_index && welded.faces[h / 3][h % 3] == welded.faces[other / 3][other % 3])
      across[h] = no_index;
  }
  return across;
}

}  // namespace

RegionGrowingWinding::RegionGrowingWinding(const WeldedMesh& welded, const Planes& planes,
                                           const WindingJumps& jumps, const Surroundings* around)
    : welded_(welded),
      planes_(planes),
      jumps_(jumps),
      around_(around),
      cut_faces_(planes.size()),
      across_(oriented_neighbors(welded, welded.edges)),
      front_(3 * welded.faces.size(), unknown) {
  const auto& open = welded.open_component;
  if (!open.empty() && std::find(open.begin(), open.end(), no_index) == open.end()) {
    std::fill(front_.begin(), front_.end(), 0);  // no face is closed
    return;
  }
  parallel_for(planes.size(), planes_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) cut_faces_[i] = trace(planes[i]);
  });
  if (around_) leave_out_incomplete();
  grow();
  if (around_) grow_from_cut_faces();
}

// Faces that meet an incomplete face may be outside the part and change w there.
void RegionGrowingWinding::leave_out_incomplete() {
  for (Index h = 0; h < across_.size(); ++h) {
    if (across_[h] != no_index && (!is_complete(h / 3) || !is_complete(across_[h] / 3)))
      across_[h] = no_index;
  }
}

RegionGrowingWinding::CutFace RegionGrowingWinding::trace(const Plane& plane) const {
  CutFace cut;
  if (plane.faces.size() > 1) {
    cut.is_met.fill(true);
    return cut;
  }
  for (const Meeting* meeting : plane.meetings) trace_meeting(*meeting, plane.faces[0], cut);
  return cut;
}

// Adds the changes of w along the edges of `face` that a meeting causes. A common segment that ends
// on an edge changes w along this edge, unless the other face contains the edge.
void RegionGrowingWinding::trace_meeting(const Meeting& meeting, Index face, CutFace& cut) const {
  const bool is_first = meeting.first == face;
  const Contacts& contacts = meeting.contacts;
  const auto& sides = is_first ? contacts.first_sides : contacts.second_sides;
  const auto& other_sides = is_first ? contacts.second_sides : contacts.first_sides;
  const int count = jumps_.multiplicity(is_first ? meeting.second : meeting.first);
  const bool reaches_front =
      std::any_of(other_sides.begin(), other_sides.end(), [](int side) { return side > 0; });
  for (int i = 0; i < contacts.count; ++i) {
    const Contact& contact = contacts.contacts[static_cast<std::size_t>(i)];
    const FaceSimplex simplex = is_first ? contact.first : contact.second;
    if (simplex < 3) cut.is_met[simplex] = true;
    if (simplex < 3 || simplex == interior) continue;
    const Index edge = simplex - 3U;
    const int from = sides[edge], to = sides[next_corner(edge)];
    if (contacts.count < 2 || !reaches_front || from * to >= 0) continue;
    cut.along[edge] += from > 0 ? count : -count;
  }
}

// Returns the smallest of a whole face and its whole neighbors, all of which have the same w in
// front. If many faces meet in one place, small faces lie near its outside, where rays cross fewer
// faces.
Index RegionGrowingWinding::seed_near(Index face) const {
  const auto extent = [&](Index f) {
    const Triangle t = welded_.triangle(f);
    return std::max((t[1] - t[0]).cwiseAbs().maxCoeff(), (t[2] - t[0]).cwiseAbs().maxCoeff());
  };
  Index seed = face;
  for (Index i = 0; i < 3; ++i) {
    const Index other = across_[3 * face + i];
    if (other != no_index && planes_.is_whole(other / 3) && extent(other / 3) < extent(seed))
      seed = other / 3;
  }
  return seed;
}

// Casts rays from whole faces only. A cut face is tested more easily after it is cut.
void RegionGrowingWinding::grow() {
  std::optional<RayCastFrontWinding> ray;
  for (Index f = 0; f < welded_.faces.size(); ++f) {
    if (!planes_.is_whole(f) || front_[3 * f] != unknown || !is_complete(f)) continue;
    if (rays_ % few == 0 && rays_ <= few) ray.emplace(welded_, rays_ == 0 ? 1 : many, around_);
    const ExactGeometry geometry(welded_.points, welded_.faces);
    const Index seed = seed_near(f);
    const auto& [a, b, c] = welded_.faces[seed];
    ++rays_;
    spread(f, 0, ray->in_front_of({geometry.given(a), geometry.given(b), geometry.given(c)}, seed));
  }
}

// Casts rays from cut faces that are connected to no whole face in the part. In the whole mesh,
// such a face may be connected to one.
void RegionGrowingWinding::grow_from_cut_faces() {
  std::optional<RayCastFrontWinding> ray;
  for (Index f = 0; f < welded_.faces.size(); ++f) {
    if (planes_.is_whole(f) || !is_complete(f) || welded_.first_copy[f] != f) continue;
    const CutFace& cut = cut_faces_[planes_.plane_of(f)];
    for (Index i = 0; i < 3; ++i) {
      if (cut.is_met[i] || front_[3 * f + i] != unknown) continue;
      if (!ray) ray.emplace(welded_, many, around_);
      ++rays_;
      spread(f, i, cast_at_corner(*ray, f, i));
    }
  }
}

int RegionGrowingWinding::cast_at_corner(const RayCastFrontWinding& ray, Index face,
                                         Index i) const {
  int w = 0;
  cut_plane(welded_, planes_[planes_.plane_of(face)], jumps_, [&](const PlaneFacets& facets) {
    w = ray.in_front_of(facets.corners(facets.facet_at_corner(i)), face);
    return std::vector<char>(facets.size(), 0);
  });
  return w;
}

void RegionGrowingWinding::spread(Index face, Index at, int w) {
  visit_corner(face, at, w);
  while (!stack_.empty()) {
    const Index corner = stack_.back();
    stack_.pop_back();
    const Index f = corner / 3, i = corner % 3;
    const int here = front_[corner];
    if (planes_.is_whole(f)) {
      for (Index k = 0; k < 3; ++k) {
        const Index out = across_[3 * f + k];
        if (out == no_index) continue;
        visit_corner(out / 3, out % 3, here);
        if (!planes_.is_whole(out / 3)) visit_corner(out / 3, next_corner(out % 3), here);
      }
      continue;
    }
    step_across(f, i, here);
    const CutFace& cut = cut_faces_[planes_.plane_of(f)];
    const Index before = previous_corner(i);
    visit_corner(f, next_corner(i), here + cut.along[i]);
    visit_corner(f, before, here - cut.along[before]);
  }
}

// A whole face has the same w at all corners.
void RegionGrowingWinding::visit_corner(Index face, Index i, int w) {
  if (front_[3 * face + i] != unknown) return;
  if (planes_.is_whole(face)) {
    for (Index k = 0; k < 3; ++k) front_[3 * face + k] = w;
    stack_.push_back(3 * face + i);
    return;
  }
  if (cut_faces_[planes_.plane_of(face)].is_met[i] || welded_.first_copy[face] != face) return;
  front_[3 * face + i] = w;
  stack_.push_back(3 * face + i);
}

// Propagates w to both neighbors of the face at the corner, next to the common edges.
void RegionGrowingWinding::step_across(Index face, Index i, int w) {
  const Index out = across_[3 * face + i];
  if (out != no_index) visit_corner(out / 3, next_corner(out % 3), w);
  const Index in = across_[3 * face + previous_corner(i)];
  if (in != no_index) visit_corner(in / 3, in % 3, w);
}

// On the straight line from a corner to any point of the face, w changes only at intersecting
// faces. It decreases at most by the faces that have the corner behind them, and increases at most
// by the others.
bool RegionGrowingWinding::is_hidden(const Plane& plane, int winding_level) const {
  if (plane.faces.size() > 1 || jumps_.multiplicity(plane.faces[0]) != 1) return false;
  const Index face = plane.faces[0];
  for (Index i = 0; i < 3; ++i) {
    const std::optional<int> w = at(face, i);
    if (!w) continue;
    int least = *w, most = *w;
    for (const Meeting* meeting : plane.meetings) {
      const bool is_first = meeting->first == face;
      const Contacts& contacts = meeting->contacts;
      const int side = is_first ? contacts.first_sides[i] : contacts.second_sides[i];
      const int change = side * jumps_.multiplicity(is_first ? meeting->second : meeting->first);
      (change < 0 ? least : most) += change;
    }
    if (least >= winding_level || most + 1 < winding_level) return true;
  }
  return false;
}

}  // namespace transformesh
