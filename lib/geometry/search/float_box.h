/// Boxes in floats, rounded outwards. They take half the memory of boxes in doubles, and overlap
/// whenever the boxes in doubles overlap. Coordinates beyond the range of floats become infinite.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using FloatBox = Eigen::AlignedBox3f;

/// float_below() returns the largest float that is not above the value; float_above() returns the
/// smallest float that is not below it.
float float_below(double value);
float float_above(double value);

/// Returns the smallest box in floats that contains a box in doubles.
FloatBox float_box(const Vec3& minimum, const Vec3& maximum);

/// Translates and scales boxes such that floats resolve them best, for shapes that are small or far
/// from the origin. The median of the points becomes the origin, and the size becomes about 1.
/// Hence a few distant points do not move the origin. If magnitudes exceed the range of floats,
/// coordinates are replaced by a monotonic function of their logarithms. Boxes that overlap still
/// overlap.
class BoxFrame {
 public:
  BoxFrame() = default;
  explicit BoxFrame(std::span<const Vec3> points);
  FloatBox box(const Vec3& minimum, const Vec3& maximum) const {
    return is_wide_ ? wide_box(minimum, maximum)
                    : float_box((minimum - origin_) * scale_, (maximum - origin_) * scale_);
  }

 private:
  FloatBox wide_box(const Vec3& minimum, const Vec3& maximum) const;

  Vec3 origin_ = Vec3::Zero();
  double scale_ = 1;
  bool is_wide_ = false;
};

/// Returns the center of a box along an axis; infinite bounds are replaced by the largest float.
inline double center(const FloatBox& box, std::size_t axis) {
  constexpr float largest = std::numeric_limits<float>::max();
  const double low = std::clamp(box.min()[static_cast<Eigen::Index>(axis)], -largest, largest);
  const double high = std::clamp(box.max()[static_cast<Eigen::Index>(axis)], -largest, largest);
  return (low + high) / 2;
}

std::vector<FloatBox> face_boxes(const Mesh& mesh);
/// Returns the bounding boxes of the faces with the given indices, in the order of these indices.
std::vector<FloatBox> face_boxes(const Mesh& mesh, std::span<const Index> faces);

}  // namespace transformesh
