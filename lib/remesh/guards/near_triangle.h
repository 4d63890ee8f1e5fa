/// Computes the distances of many points from a triangle.
///
/// Each result is the distance from one point of the triangle, the closest point unless rounding
/// selects another one. The distance is too large if rounding selects another point, which happens
/// in slivers. The distance is too small by at most the rounding error of a coordinate. Reference
/// for the regions: Ericson, "Real-time collision detection", 2005, section 5.1.5.
#pragma once

#include <algorithm>

#include "remesh/guards/triangle_axes.h"

namespace transformesh {

class NearTriangle {
 public:
  explicit NearTriangle(const Triangle& triangle) : axes_(triangle) {}

  double squared_distance(const Vec3& point) const {
    const TriangleAxes::Place place = axes_.place_of(point);
    if (place.first > 0 && place.second > 0 && place.rest() > 0) return place.away.squaredNorm();
    const Vec3 way = point - axes_.corner;
    const Vec3 &first = axes_.first, &second = axes_.second;
    double least = -1;
    const auto offer = [&](const Vec3& from, const Vec3& along) {
      const double squared = squared_distance_of_segment(from, along);
      least = least < 0 ? squared : std::min(least, squared);
    };
    // The closest point is on an edge whose line separates the point from the triangle.
    if (!(place.first > 0)) offer(way, second);
    if (!(place.second > 0)) offer(way, first);
    if (!(place.rest() > 0)) offer(way - first, second - first);
    return least;
  }

 private:
  /// Returns the squared distance of a point from a segment. `point` is relative to the segment's
  /// first end.
  static double squared_distance_of_segment(const Vec3& point, const Vec3& along) {
    const double product = along.dot(point), squared = along.squaredNorm();
    if (!(product > 0)) return point.squaredNorm();
    return (point - (product < squared ? product / squared : 1.0) * along).squaredNorm();
  }

  TriangleAxes axes_;
};

}  // namespace transformesh
