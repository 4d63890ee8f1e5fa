/// Boxes in floats, rounded outwards: half the size of boxes in doubles, and still no overlap in
/// doubles is missed. Coordinates beyond the floats' range give infinite bounds.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using FloatBox = Eigen::AlignedBox3f;

/// The largest float that is not above the value, and the smallest that is not below it.
float float_below(double value);
float float_above(double value);

/// The smallest box in floats around a box in doubles.
FloatBox float_box(const Vec3& minimum, const Vec3& maximum);

/// Moves and scales boxes so that floats resolve them best, however small the shape is or however
/// far from the origin: the middle of most points becomes the origin and the size about 1. So a
/// point that is far away costs the others nothing. Where magnitudes go beyond what floats hold,
/// coordinates are replaced by what ascends with their logarithms. Overlaps stay overlaps.
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

/// The middle of a box along an axis, infinite bounds counted as the largest float.
inline double center(const FloatBox& box, std::size_t axis) {
  constexpr float largest = std::numeric_limits<float>::max();
  const double low = std::clamp(box.min()[static_cast<Eigen::Index>(axis)], -largest, largest);
  const double high = std::clamp(box.max()[static_cast<Eigen::Index>(axis)], -largest, largest);
  return (low + high) / 2;
}

/// A box around each face.
std::vector<FloatBox> face_boxes(const Mesh& mesh);
/// A box around each of the faces named, in that order.
std::vector<FloatBox> face_boxes(const Mesh& mesh, std::span<const Index> faces);

}  // namespace transformesh
