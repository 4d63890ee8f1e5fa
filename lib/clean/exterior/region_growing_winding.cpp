#include "clean/exterior/region_growing_winding.h"

#include <algorithm>
#include <numeric>

#include "clean/arrange/cut_plane.h"
#include "mesh/connected_minima.h"
#include "mesh/corners.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t planes_per_counting_task = 256;  ///< affects time only
/// Up to this number of rays, testing all faces costs less than building a hierarchy. After the
/// first `few` rays, a hierarchy for `many` rays is built. Both numbers are choices and affect only
/// the time.
constexpr std::size_t few = 8;
constexpr std::size_t many = 1000;

}  // namespace

RegionGrowingWinding::RegionGrowingWinding(const WeldedMesh& welded, const Planes& planes,
                                           const WindingJumps& jumps, const Surroundings* around)
    : welded_(welded), planes_(planes), jumps_(jumps), around_(around), across_(welded.opposites) {
  const auto& open = welded.open_component;
  has_no_closed_face_ =
      !open.empty() && std::find(open.begin(), open.end(), no_index) == open.end();
  if (has_no_closed_face_) return;
  cut_faces_.resize(planes.size());
  parallel_for(planes.size(), planes_per_counting_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) cut_faces_[i] = trace(planes[i]);
  });
  front_.assign(3 * planes.size(), unknown);
  if (around_) leave_out_incomplete();
  find_regions();
  list_neighbors();
  grow();
  if (around_) grow_from_cut_faces();
}

// Removes incomplete faces (not all faces around them are loaded) from the adjacency, so that they
// do not propagate the winding number w. Faces that meet an incomplete face may be missing in this
// part of the mesh, and would change w along its edges.
void RegionGrowingWinding::leave_out_incomplete() {
  complete_across_ = welded_.opposites;
  for (Index h = 0; h < complete_across_.size(); ++h) {
    Index& across = complete_across_[h];
    if (across != no_index && (!is_complete(h / 3) || !is_complete(across / 3))) across = no_index;
  }
  across_ = complete_across_;
}

void RegionGrowingWinding::find_regions() {
  region_of_ = connected_minima(welded_.faces.size(), [&](Index face, const auto& visit) {
    if (!planes_.is_whole(face)) return;
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      if (across_[h] != no_index && planes_.is_whole(across_[h] / 3)) visit(across_[h] / 3);
  });
  first_face_ = number_components(region_of_, [&](Index face) { return planes_.is_whole(face); });
  region_front_.assign(first_face_.size(), unknown);
}

// Lists for each region of connected faces without intersections the halfedges of cut faces next to
// the region (counting sort).
void RegionGrowingWinding::list_neighbors() {
  const auto for_each = [&](const auto& visit) {
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const Index face = planes_[i].faces[0];
      for (Index h = 3 * face; h < 3 * face + 3; ++h)
        if (across_[h] != no_index && planes_.is_whole(across_[h] / 3))
          visit(region_of_[across_[h] / 3], h);
    }
  };
  cut_offsets_.assign(first_face_.size() + 2, 0);
  for_each([&](Index region, Index) { ++cut_offsets_[region + 2]; });
  std::partial_sum(cut_offsets_.begin(), cut_offsets_.end(), cut_offsets_.begin());
  cut_at_.resize(cut_offsets_.back());
  for_each([&](Index region, Index h) { cut_at_[cut_offsets_[region + 1]++] = h; });
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

// Adds to `cut.along` the changes of the winding number w along the edges of `face` that an
// intersecting face causes. If the common segment of both faces ends on an edge, w changes along
// this edge. Exception: the other face contains the edge.
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

// Returns the smallest of a face and its neighbors that have no intersections. All of these have
// the same winding number w in front. If many faces intersect in one place, the smallest faces
// usually lie at the outside of this place, where a ray crosses fewer faces.
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

// Casts rays only from whole faces (faces without intersections). For a cut face, winding numbers
// are easier to find after the face is cut.
void RegionGrowingWinding::grow() {
  std::optional<RayCastFrontWinding> ray;
  for (Index region = 0; region < first_face_.size(); ++region) {
    const Index f = first_face_[region];
    if (region_front_[region] != unknown || !is_complete(f)) continue;
    if (rays_ % few == 0 && rays_ <= few) ray.emplace(welded_, rays_ == 0 ? 1 : many, around_);
    const ExactGeometry geometry(welded_.points, welded_.faces);
    const Index seed = seed_near(f);
    const auto& [a, b, c] = welded_.faces[seed];
    ++rays_;
    visit_region(region,
                 ray->in_front_of({geometry.given(a), geometry.given(b), geometry.given(c)}, seed));
    spread();
  }
}

// Casts rays from cut faces that are not connected to a whole face (a face without intersections)
// in this part of the mesh. In the whole mesh, such a face may be connected to a whole face.
void RegionGrowingWinding::grow_from_cut_faces() {
  std::optional<RayCastFrontWinding> ray;
  for (Index f = 0; f < welded_.faces.size(); ++f) {
    if (planes_.is_whole(f) || !is_complete(f) || welded_.first_copy[f] != f) continue;
    const CutFace& cut = cut_faces_[planes_.plane_of(f)];
    for (Index i = 0; i < 3; ++i) {
      if (cut.is_met[i] || at(f, i)) continue;
      if (!ray) ray.emplace(welded_, many, around_);
      ++rays_;
      visit_corner(f, i, cast_at_corner(*ray, f, i));
      spread();
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

void RegionGrowingWinding::spread() {
  while (!region_stack_.empty() || !corner_stack_.empty()) {
    const bool is_region = corner_stack_.empty();
    std::vector<Index>& stack = is_region ? region_stack_ : corner_stack_;
    const Index top = stack.back();
    stack.pop_back();
    is_region ? spread_from_region(top) : spread_from_corner(top);
  }
}

void RegionGrowingWinding::spread_from_region(Index region) {
  const int w = region_front_[region];
  for (Index k = cut_offsets_[region]; k < cut_offsets_[region + 1]; ++k) {
    const Index face = cut_at_[k] / 3, i = cut_at_[k] % 3;
    visit_corner(face, i, w);
    visit_corner(face, next_corner(i), w);
  }
}

// Propagates the winding number w from a corner of a cut face along both edges at the corner to the
// other two corners. Also propagates w across these edges to the neighbors of the face.
void RegionGrowingWinding::spread_from_corner(Index corner) {
  const Index face = corner / 3, i = corner % 3, before = previous_corner(i);
  const int w = at_cut_face(face, i);
  const Index out = across_[3 * face + i], in = across_[3 * face + before];
  if (out != no_index) visit_face(out / 3, next_corner(out % 3), w);
  if (in != no_index) visit_face(in / 3, in % 3, w);
  const CutFace& cut = cut_faces_[planes_.plane_of(face)];
  visit_corner(face, next_corner(i), w + cut.along[i]);
  visit_corner(face, before, w - cut.along[before]);
}

// Assigns the winding number w to a face near its corner `i`. If the face has no intersections, w
// is the same in its whole region of connected faces without intersections, which gets w.
void RegionGrowingWinding::visit_face(Index face, Index i, int w) {
  planes_.is_whole(face) ? visit_region(region_of_[face], w) : visit_corner(face, i, w);
}

void RegionGrowingWinding::visit_region(Index region, int w) {
  if (region_front_[region] != unknown) return;
  region_front_[region] = w;
  region_stack_.push_back(region);
}

void RegionGrowingWinding::visit_corner(Index face, Index i, int w) {
  const Index plane = planes_.plane_of(face);
  int& front = front_[3 * plane + i];
  if (front != unknown || cut_faces_[plane].is_met[i] || welded_.first_copy[face] != face) return;
  front = w;
  corner_stack_.push_back(3 * face + i);
}

// On the straight line from a corner to any point of the face, the winding number w changes only at
// intersecting faces. It decreases at most by the number of intersecting faces behind which the
// corner is, and increases at most by the number of the other intersecting faces.
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
