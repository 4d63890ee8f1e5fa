/// Boxes in floats, rounded outwards: half the size of boxes in doubles, and still no overlap in
/// doubles is missed. Coordinates beyond the floats' range give infinite bounds.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

struct FloatBox {
  std::array<float, 3> minimum;
  std::array<float, 3> maximum;
};

/// The largest float that is not above the value, and the smallest that is not below it.
float float_below(double value);
float float_above(double value);

/// The smallest box in floats around a box in doubles.
FloatBox float_box(const Vec3& minimum, const Vec3& maximum);

/// The middle of a box along an axis, infinite bounds counted as the largest float.
double centre(const FloatBox& box, std::size_t axis);

/// One box around each face.
std::vector<FloatBox> face_boxes(const Mesh& mesh);
/// One box around each of the faces named, in that order.
std::vector<FloatBox> face_boxes(const Mesh& mesh, std::span<const Index> faces);

}  // namespace transformesh
