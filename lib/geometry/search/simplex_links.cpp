#include "geometry/search/simplex_links.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace transformesh {
namespace {

/// Exceeds the rounding error of a computed direction, whose coordinate differences are rounded
/// once.
constexpr double direction_error = 1e-14;
const FloatBox everything = float_box(Vec3::Constant(-2), Vec3::Constant(2));

using Edge = std::pair<Index, Index>;

/// Crowded corners and edges, which are those with more than `most_uncrowded` faces. They have
/// numbers: a corner has the index of its point, an edge has the number of points plus its index in
/// `edges`.
struct Crowds {
  std::vector<char> is_crowded;  ///< 1 for each point that is a crowded corner
  std::vector<Edge> edges;       ///< crowded edges, sorted
};

bool has_crowded_corners(std::span<const Face> faces, std::size_t points, Crowds& crowds) {
  std::vector<Index> counts(points, 0);
  for (const Face& face : faces)
    for (const Index corner : face) ++counts[corner];
  if (std::none_of(counts.begin(), counts.end(), [](Index n) { return n > most_uncrowded; }))
    return false;
  crowds.is_crowded.resize(points);
  std::transform(counts.begin(), counts.end(), crowds.is_crowded.begin(),
                 [](Index count) { return count > most_uncrowded ? 1 : 0; });
  return true;
}

Edge edge_at(const Face& face, std::size_t i) { return std::minmax({face[i], face[(i + 1) % 3]}); }

void find_crowded_edges(std::span<const Face> faces, Crowds& crowds) {
  std::vector<Edge> edges;
  for (const Face& face : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge edge = edge_at(face, i);
      if (crowds.is_crowded[edge.first] && crowds.is_crowded[edge.second]) edges.push_back(edge);
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last] == edges[first]) ++last;
    if (last - first > most_uncrowded) crowds.edges.push_back(edges[first]);
  }
}

// Returns the unit vector from one point to another. If the points are equal or their difference
// overflows, the result is not finite.
Vec3 direction(const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  return (along / along.cwiseAbs().maxCoeff()).normalized();
}

FloatBox box_around(const Vec3& low, const Vec3& high, double margin) {
  const FloatBox box = float_box(low.array() - margin, high.array() + margin);
  return margin < 1 ? box : everything;  // a NaN margin gives `everything`, too
}

// Returns a box around the direction in which a face leaves its edge, perpendicular to the edge.
FloatBox direction_box(const Vec3& from, const Vec3& to, const Vec3& opposite) {
  const Vec3 along = direction(from, to), side = direction(from, opposite);
  const Vec3 across = side - along.dot(side) * along;
  const double length = across.norm();
  const Vec3 unit = across / length;
  return box_around(unit, unit, direction_error / length);
}

class SimplexLinkFinder {
 public:
  SimplexLinkFinder(std::span<const Vec3> points, const Crowds& crowds)
      : points_(points), crowds_(crowds) {}

  // Returns the link boxes of a face: one for its first crowded edge, and one for each crowded
  // corner, but at most three in total. Link boxes bound the directions from an edge or corner into
  // the face.
  LinkBoxes operator()(const Face& face) const {
    LinkBoxes boxes;
    std::size_t count = add_edge(face, boxes[0]) ? 1 : 0;
    for (std::size_t i = 0; i < 3 && count < boxes.size(); ++i) {
      if (!crowds_.is_crowded[face[i]]) continue;
      boxes[count++] = {face[i], arc_box(points_[face[i]], points_[face[(i + 1) % 3]],
                                         points_[face[(i + 2) % 3]])};
    }
    return boxes;
  }

 private:
  bool add_edge(const Face& face, LinkBox& box) const {
    for (std::size_t i = 0; i < 3 && !crowds_.edges.empty(); ++i) {
      const Edge edge = edge_at(face, i);
      const auto found = std::lower_bound(crowds_.edges.begin(), crowds_.edges.end(), edge);
      if (found == crowds_.edges.end() || *found != edge) continue;
      box.link = static_cast<Index>(points_.size() +
                                    static_cast<std::size_t>(found - crowds_.edges.begin()));
      box.box =
          direction_box(points_[edge.first], points_[edge.second], points_[face[(i + 2) % 3]]);
      return true;
    }
    return false;
  }

  std::span<const Vec3> points_;
  const Crowds& crowds_;
};

// Calls visit(box of a, box of b) for each corner or edge at which both arguments have a link box.
template <class Visit>
void for_each_common(const LinkBoxes& a, const LinkBoxes& b, const Visit& visit) {
  for (const LinkBox& i : a)
    for (const LinkBox& k : b)
      if (i.link == k.link && i.link != no_index) visit(i, k);
}

}  // namespace

// The distance from the arc to its chord is largest at the midpoint.
FloatBox arc_box(const Vec3& corner, const Vec3& a, const Vec3& b) {
  const Vec3 u = direction(corner, a), w = direction(corner, b);
  const double sagitta = 1 - (u + w).norm() / 2;
  return box_around(u.cwiseMin(w), u.cwiseMax(w), sagitta + direction_error);
}

SimplexLinks find_simplex_links(std::span<const Vec3> points, std::span<const Face> faces) {
  SimplexLinks links;
  Crowds crowds;
  if (!has_crowded_corners(faces, points.size(), crowds)) return links;
  find_crowded_edges(faces, crowds);
  const SimplexLinkFinder boxes_of(points, crowds);
  links.row_of.assign(faces.size(), no_index);
  for (Index f = 0; f < faces.size(); ++f) {
    const LinkBoxes boxes = boxes_of(faces[f]);
    if (boxes[0].link == no_index) continue;
    links.row_of[f] = static_cast<Index>(links.boxes.size());
    links.boxes.push_back(boxes);
  }
  return links;
}

bool are_apart(const LinkBoxes& a, const LinkBoxes& b) {
  bool apart = false;
  for_each_common(
      a, b, [&](const LinkBox& i, const LinkBox& k) { apart = apart || !i.box.intersects(k.box); });
  return apart;
}

LinkBoxes common_links(const LinkBoxes& a, const LinkBoxes& b) {
  LinkBoxes result;
  std::size_t count = 0;
  for_each_common(a, b, [&](const LinkBox& i, const LinkBox& k) {
    result[count++] = {i.link, i.box.merged(k.box)};
  });
  return result;
}

}  // namespace transformesh
