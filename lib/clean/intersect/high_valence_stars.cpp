#include "clean/intersect/high_valence_stars.h"

#include <algorithm>
#include <bit>

#include "geometry/search/sort_pairs.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t pairs_per_task = 1024;  ///< affects time only

/// True if `to` and `from` are on the same side of the center. The projections of the three points
/// must be collinear.
bool is_same_side(const Vec3& center, const Vec3& from, const Vec3& to,
                  PlaneProjection projection) {
  const int axis = from[projection.u] != center[projection.u] ? projection.u : projection.v;
  return from[axis] < center[axis] ? to[axis] < center[axis] : to[axis] > center[axis];
}

}  // namespace

std::vector<char> HighValenceStars::crowded_points(const WeldedMesh& welded,
                                                   const SimplexLinks& links) {
  std::vector<char> is_crowded;
  if (links.empty()) return is_crowded;
  is_crowded.assign(welded.points.size(), 0);
  for (const LinkBoxes& boxes : links.boxes)
    for (const LinkBox& box : boxes)
      if (box.link < is_crowded.size()) is_crowded[box.link] = 1;
  return is_crowded;
}

HighValenceStars::HighValenceStars(const WeldedMesh& welded, std::span<const char> is_embedded,
                                   std::span<const char> is_crowded)
    : welded_(&welded) {
  std::vector<Index> halfedge_from(is_crowded.size(), no_index);
  for (Index h = 0; h < 3 * welded.faces.size() && !is_crowded.empty(); ++h) {
    const Index point = welded.faces[h / 3][h % 3];
    if (is_crowded[point] && is_embedded[point]) halfedge_from[point] = h;
  }
  for (Index point = 0; point < halfedge_from.size(); ++point) {
    if (halfedge_from[point] == no_index) continue;
    if (stars_.empty()) {
      star_of_.assign(welded.faces.size(), no_index);
      for (Index f = 0; f < welded.faces.size(); ++f) boxes_.push_back(welded.box(f));
    }
    add(point, halfedge_from[point]);
  }
}

void HighValenceStars::add(Index center, Index halfedge) {
  Star& star = stars_.emplace_back();
  star.center = center;
  AxisDirections directions = all_axis_directions;
  std::vector<Index> halfedges;
  for (Index h = halfedge; halfedges.empty() || h != halfedge;
       h = welded_->opposites[previous_halfedge(h)]) {
    halfedges.push_back(h);
    directions &= welded_->directions[h / 3].looks;
  }
  const int way = std::countr_zero(directions), axis = way / 2;
  star.projection = {(axis + 1) % 3, (axis + 2) % 3};
  if (way % 2 == 1) std::swap(star.projection.u, star.projection.v);
  star.box = boxes_[halfedge / 3];
  for (const Index h : halfedges) {
    star.faces.push_back(h / 3);
    star.rim.push_back(welded_->faces[h / 3][(h + 1) % 3]);
    star.is_late.push_back(is_ahead(star, star.rim[0], star.rim.back()) ? 0 : 1);
    Index& owner = star_of_[h / 3];
    if (owner == no_index) owner = static_cast<Index>(stars_.size() - 1);
    star.box = star.box.merged(boxes_[h / 3]);
  }
}

/// True if the counter-clockwise angle around the center, from the point `from` to the point `to`,
/// is less than pi in the projection.
bool HighValenceStars::is_ahead(const Star& star, Index from, Index to) const {
  const Vec3 &a = welded_->points[from], &b = welded_->points[to];
  const Vec3& center = welded_->points[star.center];
  const int sign = orient2d(center, a, b, star.projection);
  return sign > 0 || (sign == 0 && is_same_side(center, a, b, star.projection));
}

/// Returns the sector (the projection of a face of the star) that contains the point. If the point
/// is on the boundary of two sectors, returns the second one in counter-clockwise order. The
/// projections of the point and the center must differ.
std::size_t HighValenceStars::sector(const Star& star, Index point) const {
  const bool is_late = !is_ahead(star, star.rim[0], point);
  std::size_t first = 0, last = star.rim.size();
  while (last - first > 1) {
    const std::size_t middle = (first + last) / 2;
    const bool comes_before = star.is_late[middle] != (is_late ? 1 : 0)
                                  ? is_late
                                  : is_ahead(star, star.rim[middle], point);
    (comes_before ? first : last) = middle;
  }
  return first;
}

/// Returns the sectors that the projection of the face touches. Returns all sectors if the
/// projection touches the center. Exception: if only one corner of the face is projected onto the
/// center, the other two corners determine the sectors.
HighValenceStars::Range HighValenceStars::sectors(const Star& star, const Face& face) const {
  const Range all{0, star.faces.size()};
  const Vec3& center = welded_->points[star.center];
  const int u = star.projection.u, v = star.projection.v;
  std::array<Index, 3> corners;
  auto* const end = std::copy_if(face.begin(), face.end(), corners.begin(), [&](Index p) {
    return welded_->points[p][u] != center[u] || welded_->points[p][v] != center[v];
  });
  if (end - corners.begin() < 2) return all;
  // Find the first corner `from` and the last corner `to` in counter-clockwise order around the
  // center.
  Index from = no_index, to = no_index;
  for (const auto* i = corners.begin(); i != end; ++i) {
    bool has_behind = false, has_ahead = false;
    for (const auto* k = corners.begin(); k != end; ++k) {
      const bool is_one_way = is_ahead(star, *i, *k), is_other_way = is_ahead(star, *k, *i);
      if (!is_one_way && !is_other_way)
        return all;  // the two corners are on opposite sides of the center
      has_behind |= !is_one_way;
      has_ahead |= !is_other_way;
    }
    if (!has_behind) from = *i;
    if (!has_ahead) to = *i;
  }
  if (from == no_index || to == no_index) return all;
  // A corner on the boundary of two sectors touches both, and sector() returns the second one.
  // Therefore the range starts one sector earlier.
  const std::size_t count = all.count;
  const std::size_t first = sector(star, from);
  const std::size_t steps = (sector(star, to) + count - first) % count;
  return {(first + count - 1) % count, std::min(count, steps + 2)};
}

void HighValenceStars::add_pairs(Index star_number, Index face,
                                 std::vector<Bvh::Pair>& pairs) const {
  const Star& star = stars_[star_number];
  const auto [first, count] = sectors(star, welded_->faces[face]);
  for (std::size_t i = 0; i < count; ++i) {
    const Index other = star.faces[(first + i) % star.faces.size()];
    if (star_of_[other] == star_number && boxes_[other].intersects(boxes_[face]))
      pairs.emplace_back(std::min(face, other), std::max(face, other));
  }
}

std::vector<Bvh::Pair> HighValenceStars::find_pairs(std::span<const Index> others) const {
  // Pairs of the index of a star and a face whose box overlaps the star's box.
  std::vector<Bvh::Pair> near;
  std::vector<FloatBox> boxes;
  for (const Index f : others) boxes.push_back(boxes_[f]);
  const Bvh bvh(boxes);
  boxes.clear();
  for (const Star& star : stars_) boxes.push_back(star.box);
  const Bvh stars(boxes);
  for (Index s = 0; s < stars_.size(); ++s) {
    bvh.visit_overlaps(stars_[s].box, [&](Index i) {
      near.emplace_back(s, others[i]);
      return true;
    });
    stars.visit_overlaps(stars_[s].box, [&](Index t) {
      for (const Index f : stars_[t].faces)
        if (t > s && star_of_[f] == t) near.emplace_back(s, f);
      return true;
    });
  }
  std::vector<std::vector<Bvh::Pair>> lists(near.size() / pairs_per_task + 1);
  parallel_for(near.size(), pairs_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      add_pairs(near[i].first, near[i].second, lists[first / pairs_per_task]);
  });
  return joined(lists);
}

}  // namespace transformesh
