#include "views/hull/contour_distance.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace transformesh {
namespace {

/// Value of `nearest_` for pixels whose nearest contour segment is not known; not a valid index.
constexpr std::int32_t no_segment = -1;

using Point = Eigen::Vector2f;

struct Segment {
  Point start, end;

  float squared_distance(const Point& point) const {
    const Point along = end - start;
    const float squared_length = along.squaredNorm();
    float share = squared_length > 0 ? (point - start).dot(along) / squared_length : 0.0F;
    share = std::clamp(share, 0.0F, 1.0F);
    return (start + share * along - point).squaredNorm();
  }
};

/// Computes the distance of each pixel center from the nearest segment of the contour, up to
/// `limit`. Marching squares yields the segments. Two passes over the image propagate the nearest
/// segment from pixel to pixel.
class ContourDistance {
 public:
  ContourDistance(const GrayImage& silhouette, float limit)
      : silhouette_(silhouette),
        squared_(silhouette.width, silhouette.height, limit * limit),
        nearest_(silhouette.width, silhouette.height, no_segment) {}

  GrayImage compute() {
    for (int y = 0; y + 1 < silhouette_.height; ++y)
      for (int x = 0; x + 1 < silhouette_.width; ++x) trace_cell(x, y);
    sweep_down();
    sweep_up();
    return signed_roots();
  }

 private:
  /// Adds the segments of the contour in the square whose corners are the centers of pixels (x, y)
  /// to (x + 1, y + 1), by marching squares.
  void trace_cell(int x, int y) {
    static constexpr std::array<std::array<int, 2>, 4> corners = {
        {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}};
    std::array<Point, 4> crossings;
    std::size_t count = 0;
    for (std::size_t side = 0; side < 4; ++side) {
      const auto [ax, ay] = corners[side];
      const auto [bx, by] = corners[(side + 1) % 4];
      const float a = silhouette_.at(x + ax, y + ay);
      const float b = silhouette_.at(x + bx, y + by);
      if (is_inside_contour(a) == is_inside_contour(b)) continue;
      const float share = (contour_intensity - a) / (b - a);
      const Point start(static_cast<float>(x + ax), static_cast<float>(y + ay));
      const Point end(static_cast<float>(x + bx), static_cast<float>(y + by));
      crossings[count++] = start + share * (end - start);
    }
    for (std::size_t i = 0; i + 1 < count; i += 2)
      add_segment({crossings[i], crossings[i + 1]}, x, y);
  }

  void add_segment(const Segment& segment, int x, int y) {
    const auto index = static_cast<std::int32_t>(segments_.size());
    segments_.push_back(segment);
    for (int dy = 0; dy <= 1; ++dy)
      for (int dx = 0; dx <= 1; ++dx) offer(index, x + dx, y + dy);
  }

  void offer(std::int32_t segment, int x, int y) {
    if (segment == no_segment) return;
    const Point pixel(static_cast<float>(x), static_cast<float>(y));
    const float squared = segments_[static_cast<std::size_t>(segment)].squared_distance(pixel);
    if (squared >= squared_.at(x, y)) return;
    squared_.at(x, y) = squared;
    nearest_.at(x, y) = segment;
  }

  void offer_from(int from_x, int from_y, int x, int y) {
    if (from_x < 0 || from_x >= silhouette_.width || from_y < 0 || from_y >= silhouette_.height)
      return;
    const std::int32_t segment = nearest_.at(from_x, from_y);
    if (segment != nearest_.at(x, y)) offer(segment, x, y);
  }

  void sweep_row(int y, int from_y) {
    const int width = silhouette_.width;
    for (int x = 0; x < width; ++x) {
      for (int dx = -1; dx <= 1; ++dx) offer_from(x + dx, from_y, x, y);
      offer_from(x - 1, y, x, y);
    }
    for (int x = width - 1; x >= 0; --x) offer_from(x + 1, y, x, y);
  }

  void sweep_down() {
    for (int y = 0; y < silhouette_.height; ++y) sweep_row(y, y - 1);
  }
  void sweep_up() {
    for (int y = silhouette_.height - 1; y >= 0; --y) sweep_row(y, y + 1);
  }

  GrayImage signed_roots() {
    GrayImage distances = std::move(squared_);
    for (std::size_t i = 0; i < distances.pixels.size(); ++i) {
      const float root = std::sqrt(distances.pixels[i]);
      distances.pixels[i] = is_inside_contour(silhouette_.pixels[i]) ? -root : root;
    }
    return distances;
  }

  const GrayImage& silhouette_;
  GrayImage squared_;
  Raster<std::int32_t> nearest_;
  std::vector<Segment> segments_;
};

template <class Image>
float interpolated(const Image& distances, double x, double y) {
  const int width = distances.width;
  const int height = distances.height;
  if (!(x >= -0.5 && y >= -0.5 && x <= width - 0.5 && y <= height - 0.5)) return unknown_distance;
  const double inner_x = std::clamp(x, 0.0, width - 1.0);
  const double inner_y = std::clamp(y, 0.0, height - 1.0);
  const int left = std::min(static_cast<int>(inner_x), std::max(width - 2, 0));
  const int top = std::min(static_cast<int>(inner_y), std::max(height - 2, 0));
  const int right = std::min(left + 1, width - 1);
  const int bottom = std::min(top + 1, height - 1);

  const float upper_left = distances.at(left, top);
  if (std::isinf(upper_left)) return upper_left;  // without a contour all distances are infinite
  const auto across = static_cast<float>(inner_x - left);
  const auto down = static_cast<float>(inner_y - top);
  const float upper = upper_left + across * (distances.at(right, top) - upper_left);
  const float lower = distances.at(left, bottom) +
                      across * (distances.at(right, bottom) - distances.at(left, bottom));
  return upper + down * (lower - upper);
}

}  // namespace

GrayImage signed_distance(const GrayImage& silhouette, float limit) {
  return ContourDistance(silhouette, limit).compute();
}

float distance_at(const GrayImage& distances, double x, double y) {
  return interpolated(distances, x, y);
}

float distance_at(const PackableImage& distances, double x, double y) {
  return interpolated(distances, x, y);
}

}  // namespace transformesh
