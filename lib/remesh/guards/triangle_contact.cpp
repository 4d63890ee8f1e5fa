#include "remesh/guards/triangle_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "geometry/search/bvh.h"
#include "geometry/search/simplex_links.h"
#include "remesh/guards/triangle_box.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// A gap between triangles must exceed this share of the sizes involved. Relative rounding errors
/// of gaps are below 1e-14. With a larger margin, more patches are refused; with a smaller margin,
/// contacts may be accepted.
constexpr double contact_margin = 1e-12;
constexpr double nearly_zero = 1e-9;

/// True if there is a gap between the projections onto the axis. `size` is the largest distance of
/// a corner from the origin of the coordinates.
bool is_gap(const Vec3& axis, const Triangle& first, const Triangle& second, double size) {
  const std::array<double, 3> s{axis.dot(first[0]), axis.dot(first[1]), axis.dot(first[2])};
  const std::array<double, 3> t{axis.dot(second[0]), axis.dot(second[1]), axis.dot(second[2])};
  const auto [s_low, s_high] = std::minmax({s[0], s[1], s[2]});
  const auto [t_low, t_high] = std::minmax({t[0], t[1], t[2]});
  const double least = contact_margin * size * axis.norm();
  return s_high + least < t_low || t_high + least < s_low;
}

Triangle relative_to(const Triangle& triangle, const Vec3& origin) {
  return {triangle[0] - origin, triangle[1] - origin, triangle[2] - origin};
}

Vec3 edge_of(const Triangle& triangle, std::size_t corner) {
  return triangle[(corner + 1) % 3] - triangle[corner];
}

/// Separating axis test of two triangles. The axes are both normals, the cross products of two
/// edges, and the normals of edges within the planes, for coplanar triangles.
bool are_apart(const Triangle& first, const Triangle& second) {
  const Triangle s = relative_to(first, first[0]);
  const Triangle t = relative_to(second, first[0]);
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max({size, s[i].norm(), t[i].norm()});
  const Vec3 s_normal = normal_of(s[0], s[1], s[2]);
  const Vec3 t_normal = normal_of(t[0], t[1], t[2]);
  if (is_gap(s_normal, s, t, size) || is_gap(t_normal, s, t, size)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = edge_of(s, i);
    if (is_gap(s_normal.cross(edge), s, t, size)) return true;
    if (is_gap(t_normal.cross(edge_of(t, i)), s, t, size)) return true;
    for (std::size_t j = 0; j < 3; ++j) {
      if (is_gap(edge.cross(edge_of(t, j)), s, t, size)) return true;
    }
  }
  return false;
}

Box box_of(const Triangle& t) { return Box(t[0]).extend(t[1]).extend(t[2]); }

/// True if the bounding boxes of an edge opposite to the common corner and of the other triangle
/// are disjoint, for both triangles. Then triangles that share a single corner share no other
/// point. A ray from the corner through such a point would leave one of the triangles first, at its
/// opposite edge and inside the other triangle.
bool are_apart_beyond(const Triangle& first, std::size_t i, const Triangle& second, std::size_t j) {
  const auto opposite = [](const Triangle& t, std::size_t corner) {
    return Box(t[(corner + 1) % 3]).extend(t[(corner + 2) % 3]);
  };
  return !opposite(first, i).intersects(box_of(second)) &&
         !opposite(second, j).intersects(box_of(first));
}

/// The unit directions of the four edges at the common corner of two triangles.
struct Wedges {
  /// Directions of two edges of the first triangle, then two edges of the second.
  std::array<Vec3, 4> rays;

  /// Returns the signed distance of a ray's end from the plane with normal `axis`. The sign is
  /// reversed for the second triangle, so all distances are positive if the plane separates the
  /// triangles.
  double side(const Vec3& axis, std::size_t ray) const {
    return (ray < 2 ? 1.0 : -1.0) * axis.dot(rays[ray]);
  }

  /// True if the plane separates the triangles. If rays lie in the plane, the plane is first tilted
  /// slightly away from these rays.
  bool separates(const Vec3& unit_axis) const {
    double least = 1;
    Vec3 tilt = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const double distance = side(unit_axis, i);
      if (distance < -nearly_zero) return false;
      if (distance > nearly_zero) {
        least = std::min(least, distance);
      } else {
        tilt += (i < 2 ? 1.0 : -1.0) * rays[i];
      }
    }
    const Vec3 tilted = unit_axis + 0.2 * least * tilt;
    for (std::size_t i = 0; i < 4; ++i) {
      if (side(tilted, i) < contact_margin) return false;
    }
    return true;
  }

  bool separates_either_way(const Vec3& axis) const {
    const double length = axis.norm();
    if (length < nearly_zero) return false;
    return separates(axis / length) || separates(axis / -length);
  }
};

bool are_wedges_apart(const Wedges& wedges) {
  const auto& [a, b, c, d] = wedges.rays;
  const Vec3 first_normal = a.cross(b);
  const Vec3 second_normal = c.cross(d);
  const std::array<Vec3, 10> axes = {first_normal,
                                     second_normal,
                                     a.cross(c),
                                     a.cross(d),
                                     b.cross(c),
                                     b.cross(d),
                                     first_normal.cross(a),
                                     first_normal.cross(b),
                                     second_normal.cross(c),
                                     second_normal.cross(d)};
  return std::any_of(axes.begin(), axes.end(),
                     [&](const Vec3& axis) { return wedges.separates_either_way(axis); });
}

/// True if two triangles at a common edge enclose more than a thousandth of a radian. All vectors
/// start at one end of the edge: `edge` leads to the other end, the others to the apexes.
bool is_open_hinge(const Vec3& edge, const Vec3& first_apex, const Vec3& second_apex) {
  const Vec3 first = edge.cross(first_apex);
  const Vec3 second = edge.cross(second_apex);
  const double scale = first.norm() * second.norm();
  const double smallest =
      nearly_zero * nearly_zero * edge.squaredNorm() * first_apex.norm() * second_apex.norm();
  return scale > smallest && (first.dot(second) < 0 || first.cross(second).norm() > 1e-3 * scale);
}

/// The common corners of two triangles, as their numbers in each triangle.
struct CommonCorners {
  std::array<std::size_t, 3> in_first{};
  std::array<std::size_t, 3> in_second{};
  /// Number of common corners. Also 3 if a triangle has two equal corners, because it may touch any
  /// other triangle.
  std::size_t count = 0;

  CommonCorners(const Triangle& first, const Triangle& second) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (first[i] != second[j] || count == 3) continue;
        in_first[count] = i;
        in_second[count] = j;
        ++count;
      }
    }
    if (count == 2 && (in_first[0] == in_first[1] || in_second[0] == in_second[1])) count = 3;
  }
};

/// True if the triangles are many, and all have the same first corner.
bool is_large_star(std::span<const Triangle> triangles) {
  return triangles.size() > most_uncrowded &&
         std::all_of(triangles.begin(), triangles.end(),
                     [&](const Triangle& triangle) { return triangle[0] == triangles[0][0]; });
}

/// Tests triangles with the same first corner. If two of them touch, the edge opposite to this
/// corner of one triangle meets the box of the other triangle, as in are_apart_beyond().
bool star_meets_itself(std::span<const Triangle> star) {
  std::vector<FloatBox> edges;
  edges.reserve(star.size());
  for (const auto& [corner, a, b] : star) edges.push_back(float_box(a.cwiseMin(b), a.cwiseMax(b)));
  const Bvh tree(edges);
  return std::any_of(star.begin(), star.end(), [&](const Triangle& triangle) {
    bool is_apart = true;
    tree.visit_overlaps(float_box(lowest(triangle), highest(triangle)), [&](Index other) {
      is_apart = &star[other] == &triangle || !may_touch(triangle, star[other]);
      return is_apart;
    });
    return !is_apart;
  });
}

}  // namespace

bool may_touch(const Triangle& first, const Triangle& second) {
  const CommonCorners common(first, second);
  const std::size_t i = common.in_first[0];
  const std::size_t j = common.in_second[0];
  const Vec3& origin = first[i];
  switch (common.count) {
    case 0:
      return !are_apart(first, second);
    case 1: {
      if (are_apart_beyond(first, i, second, j)) return false;
      const Wedges wedges{{(first[(i + 1) % 3] - origin).normalized(),
                           (first[(i + 2) % 3] - origin).normalized(),
                           (second[(j + 1) % 3] - origin).normalized(),
                           (second[(j + 2) % 3] - origin).normalized()}};
      return !are_wedges_apart(wedges);
    }
    case 2: {
      const Vec3 edge = first[common.in_first[1]] - origin;
      return !is_open_hinge(edge, first[3 - i - common.in_first[1]] - origin,
                            second[3 - j - common.in_second[1]] - origin);
    }
    default:  // the triangles are the same, or one has two equal corners
      return true;
  }
}

bool meet_each_other(std::span<const Triangle> triangles) {
  if (is_large_star(triangles)) return star_meets_itself(triangles);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (boxes_touch(triangles[i], triangles[j]) && may_touch(triangles[i], triangles[j]))
        return true;
  return false;
}

}  // namespace transformesh
