#include "tm/geometry/float_box.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t boxes_per_task = 4096;

FloatBox box_of_corners(const Vec3& a, const Vec3& b, const Vec3& c) {
  return float_box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
}

}  // namespace

// There is no branch, because boxes are made by the thousand and whether the nearest float is below
// the value is a coin toss. Adding 0 makes -0 positive, so that the bits are in order.
float float_above(double value) {
  const float nearest = static_cast<float>(value) + 0.0F;
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  const std::int32_t up = bits < 0 ? -1 : 1;
  return std::bit_cast<float>(bits + (nearest < value ? up : 0));
}

float float_below(double value) { return -float_above(-value); }

FloatBox float_box(const Vec3& minimum, const Vec3& maximum) {
  return {{float_below(minimum.x()), float_below(minimum.y()), float_below(minimum.z())},
          {float_above(maximum.x()), float_above(maximum.y()), float_above(maximum.z())}};
}

// Rounding keeps the order of numbers, and so boxes that overlap still do.
BoxFrame::BoxFrame(std::span<const Vec3> points) {
  if (points.empty()) return;
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  origin_ = low / 2 + high / 2;
  const double size = (high / 2 - low / 2).maxCoeff();
  if (size > 0) scale_ = std::ldexp(1.0, std::min(1000, -std::ilogb(size)));
}

std::vector<FloatBox> face_boxes(const Mesh& mesh) {
  std::vector<FloatBox> boxes(mesh.faces.size());
  parallel_for(boxes.size(), boxes_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      boxes[f] = box_of_corners(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
  });
  return boxes;
}

std::vector<FloatBox> face_boxes(const Mesh& mesh, std::span<const Index> faces) {
  std::vector<FloatBox> boxes(faces.size());
  parallel_for(boxes.size(), boxes_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto& [a, b, c] = mesh.faces[faces[i]];
      boxes[i] = box_of_corners(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
  });
  return boxes;
}

}  // namespace transformesh
