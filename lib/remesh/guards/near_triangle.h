/// A triangle that is asked for the distances of many points.
///
/// The distance is that of a point of the triangle which is the closest but for rounding. It is
/// measured to that point. So it may be too large, as in slivers, if rounding chose another point,
/// and it is too small by no more than the rounding of a coordinate.
/// Reference for the regions: Ericson, "Real-time collision detection", 2005, section 5.1.5.
#pragma once

#include <algorithm>

#include "mesh/triangle.h"

namespace transformesh {

class NearTriangle {
 public:
  explicit NearTriangle(const Triangle& triangle)
      : corner_(triangle[0]),
        first_(triangle[1] - triangle[0]),
        second_(triangle[2] - triangle[0]) {
    const Vec3 normal = first_.cross(second_);
    const double squared = normal.squaredNorm();
    if (!(squared > 0)) return;
    first_dual_ = second_.cross(normal) / squared;
    second_dual_ = normal.cross(first_) / squared;
  }

  double squared_distance(const Vec3& point) const {
    const Vec3 way = point - corner_;
    const double first = first_dual_.dot(way), second = second_dual_.dot(way);
    const double rest = 1 - first - second;
    // Without area, both duals are zero.
    if (first > 0 && second > 0 && rest > 0)
      return (way - first * first_ - second * second_).squaredNorm();
    double least = -1;
    const auto offer = [&](const Vec3& from, const Vec3& along) {
      const double squared = squared_distance_of_segment(from, along);
      least = least < 0 ? squared : std::min(least, squared);
    };
    // The closest point is on an edge whose line separates the point from the triangle.
    if (!(first > 0)) offer(way, second_);
    if (!(second > 0)) offer(way, first_);
    if (!(rest > 0)) offer(way - first_, second_ - first_);
    return least;
  }

 private:
  /// `point` is relative to the first end of the segment.
  static double squared_distance_of_segment(const Vec3& point, const Vec3& along) {
    const double product = along.dot(point), squared = along.squaredNorm();
    if (!(product > 0)) return point.squaredNorm();
    return (point - (product < squared ? product / squared : 1.0) * along).squaredNorm();
  }

  Vec3 corner_;
  Vec3 first_, second_;             ///< edges from the corner
  Vec3 first_dual_ = Vec3::Zero();  ///< its product with a way is the share of the edge
  Vec3 second_dual_ = Vec3::Zero();
};

}  // namespace transformesh
