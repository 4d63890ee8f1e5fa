#include "views/depth/plane_sweep.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "raster/camera.h"
#include "views/cameras/view.h"
#include "views/images/interpolation.h"
#include "views/photo/warp.h"

namespace transformesh {
namespace {

constexpr int most_planes = 400;  ///< largest number of planes; limits time and memory per view

/// Range of depths of the nodes inside the hull, and their bounding rectangle in the image.
struct Extent {
  double near = std::numeric_limits<double>::infinity();
  double far = 0;
  Eigen::AlignedBox2d image;

  bool is_before_camera() const { return near > 0 && near < far; }
};

Extent extent_of(const ValueGrid& hull, const Projection& projection) {
  Extent extent;
  for (std::size_t z = 0; z < hull.nodes[2]; ++z) {
    for (std::size_t y = 0; y < hull.nodes[1]; ++y) {
      const float* const row = hull.values.data() + hull.index(0, y, z);
      for (std::size_t x = 0; x < hull.nodes[0]; ++x) {
        if (!(row[x] < 0)) continue;
        const Vec3 q = projection.leftCols<3>() * hull.position(x, y, z) + projection.col(3);
        extent.near = std::min(extent.near, q.z());
        extent.far = std::max(extent.far, q.z());
        if (!(q.z() > 0)) continue;
        extent.image.extend(q.hnormalized());
      }
    }
  }
  return extent;
}

/// A view that is compared with the reference view, the view whose depths are computed. Let X be
/// the point with depth d on the ray of pixel (x, y) of the reference view. X projects to the
/// homogeneous pixel d * turn * (x, y, 1) + shift of this view.
struct Neighbor {
  GrayImage image;
  Eigen::Matrix3d turn;
  Vec3 shift;

  Neighbor(const View& reference, const View& view) : image(view.image) {
    const Projection projection = view.camera.projection();
    const Eigen::Matrix3d directions = projection.leftCols<3>();
    turn =
        directions * reference.camera.rotation.transpose() * reference.camera.intrinsics.inverse();
    shift = directions * reference.camera.center() + projection.col(3);
  }

  Eigen::Vector2d pixel_of(const Eigen::Vector2d& pixel, double depth) const {
    return (depth * turn * Vec3(pixel.x(), pixel.y(), 1) + shift).hnormalized();
  }
};

class Sweep {
 public:
  Sweep(const View& view, std::span<const View* const> neighbors, const ValueGrid& hull,
        const PlaneSweepOptions& options)
      : view_(view), image_(view.image), hull_(hull), options_(options) {
    for (const View* const neighbor : neighbors) neighbors_.emplace_back(view, *neighbor);
  }

  DepthMap run() {
    DepthMap map{GrayImage(view_.image.width, view_.image.height), 0};
    if (neighbors_.empty() || !find_planes()) return map;
    map.plane_gap = gap_;
    costs_ = {columns_, rows_, planes_};
    costs_.values.assign(size() * static_cast<std::size_t>(planes_), 1.0F);
    for (int plane = 0; plane < planes_; ++plane) score(plane);
    sums_ = semiglobal_costs(costs_, options_.semiglobal);
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) map.depth.at(left_ + x, top_ + y) = best_depth(x, y);
    return map;
  }

 private:
  bool find_planes();
  void score(int plane);
  bool mark_inside(double depth);
  void compare(const Neighbor& neighbor, double depth, float* best, float* second) const;
  void fill(const Neighbor& neighbor, double depth, int y, const ComparedRow& row) const;
  float best_depth(int x, int y) const;

  std::size_t size() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }
  double depth_of(double plane) const { return 1 / (nearest_ - gap_ * plane); }

  const View& view_;
  GrayImage image_;
  const ValueGrid& hull_;
  PlaneSweepOptions options_;
  std::vector<Neighbor> neighbors_;

  int left_ = 0, top_ = 0, columns_ = 0, rows_ = 0;  ///< rectangle of the hull in the image
  /// Part of the rectangle in which the current plane intersects the hull.
  int first_row_ = 0, end_row_ = 0;
  int first_column_ = 0, end_column_ = 0;
  int planes_ = 0;
  /// Inverse depth of the first plane, and difference of the inverse depths of consecutive planes.
  double nearest_ = 0, gap_ = 0;
  /// For each pixel of the rectangle: 1 if its point on the current plane is inside the hull, else
  /// 0.
  std::vector<std::uint8_t> is_inside_;
  MatchingCosts costs_;  ///< costs of the planes at the pixels of the rectangle
  MatchingCosts sums_;   ///< `costs_` summed along paths (semiglobal_matching.h)
};

// Sets the image rectangle that contains the hull, and the depths of the planes. From one plane to
// the next, the rectangle's center moves by at most `options_.step` pixels in each neighboring
// image, unless this requires too many planes. Returns false if the hull is not visible.
bool Sweep::find_planes() {
  const Extent extent = extent_of(hull_, view_.camera.projection());
  if (!extent.is_before_camera()) return false;
  const auto clamped = [](double value, int end) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(end)));
  };
  left_ = clamped(std::floor(extent.image.min().x()), image_.width);
  top_ = clamped(std::floor(extent.image.min().y()), image_.height);
  columns_ = clamped(std::ceil(extent.image.max().x()) + 1, image_.width) - left_;
  rows_ = clamped(std::ceil(extent.image.max().y()) + 1, image_.height) - top_;
  if (columns_ < 1 || rows_ < 1) return false;
  const Eigen::Vector2d middle = extent.image.center();
  double way = 0;
  for (const Neighbor& neighbor : neighbors_)
    way = std::max(
        way,
        (neighbor.pixel_of(middle, extent.near) - neighbor.pixel_of(middle, extent.far)).norm());
  planes_ = 1 + static_cast<int>(std::clamp(std::ceil(way / options_.step), 2.0,
                                            static_cast<double>(most_planes)));
  nearest_ = 1 / extent.near;
  gap_ = (nearest_ - 1 / extent.far) / (planes_ - 1);
  return true;
}

// Marks the pixels whose point on the plane is in the hull, or at most one cell outside. Returns
// false if there are no such pixels.
bool Sweep::mark_inside(double depth) {
  is_inside_.assign(size(), 0);
  first_row_ = rows_;
  first_column_ = columns_;
  end_row_ = end_column_ = 0;
  const auto inverse = static_cast<float>(1 / hull_.spacing);
  const auto margin = static_cast<float>(hull_.spacing);
  const Vec3 along = (view_.camera.ray(1, 0) - view_.camera.ray(0, 0)) * depth;
  const Eigen::Vector3f step = along.cast<float>() * inverse;
  for (int y = 0; y < rows_; ++y) {
    const Vec3 start = view_.camera.center() + depth * view_.camera.ray(left_, top_ + y);
    const Eigen::Vector3f from = ((start - hull_.origin).cast<float>() * inverse).array() + 0.5F;
    for (int x = 0; x < columns_; ++x) {
      const Eigen::Vector3f site = from + static_cast<float>(x) * step;
      if (!(site.minCoeff() >= 0)) continue;
      const std::array<std::size_t, 3> node{static_cast<std::size_t>(site.x()),
                                            static_cast<std::size_t>(site.y()),
                                            static_cast<std::size_t>(site.z())};
      if (node[0] >= hull_.nodes[0] || node[1] >= hull_.nodes[1] || node[2] >= hull_.nodes[2])
        continue;
      if (!(hull_.values[hull_.index(node[0], node[1], node[2])] < margin)) continue;
      is_inside_[index(x, y)] = 1;
      first_row_ = std::min(first_row_, y);
      end_row_ = y + 1;
      first_column_ = std::min(first_column_, x);
      end_column_ = std::max(end_column_, x + 1);
    }
  }
  return first_row_ < end_row_;
}

void Sweep::fill(const Neighbor& neighbor, double depth, int y, const ComparedRow& row) const {
  constexpr int first = margin<Interpolation::bilinear>;
  const int end_x = neighbor.image.width - 1 - first;
  const int end_y = neighbor.image.height - 1 - first;
  const Vec3 start = depth * neighbor.turn * Vec3(left_, top_ + y, 1) + neighbor.shift;
  const Vec3 step = depth * neighbor.turn.col(0);
  const float* const intensities = image_.row(top_ + y) + left_;
  for (int x = first_column_; x < end_column_; ++x) {
    if (is_inside_[index(x, y)] == 0) continue;
    const int i = x - first_column_;
    const Vec3 q = start + x * step;
    const double to_x = q.x() / q.z();
    const double to_y = q.y() / q.z();
    if (!(q.z() > 0 && to_x >= first && to_y >= first && to_x < end_x && to_y < end_y)) continue;
    const int column = static_cast<int>(to_x);
    const int line = static_cast<int>(to_y);
    row.is_seen[i] = 1;
    row.first[i] = intensities[x] - middle_intensity;
    row.second[i] = sample<Interpolation::bilinear>(neighbor.image, column, line,
                                                    static_cast<float>(to_x - column),
                                                    static_cast<float>(to_y - line), 0, 0)
                        .intensity -
                    middle_intensity;
  }
}

void Sweep::compare(const Neighbor& neighbor, double depth, float* best, float* second) const {
  correlate(
      end_column_ - first_column_, first_row_, end_row_, options_.correlation,
      [&](int y, const ComparedRow& row) { fill(neighbor, depth, y, row); }, {},
      [&](int y, const WindowRow& row) {
        float* const first = best + index(first_column_, y);
        float* const other = second + index(first_column_, y);
        for (int x = 0; x < end_column_ - first_column_; ++x) {
          const float correlation = row.weight[x] > 0 ? row.weight[x] - row.energy[x] : 0.0F;
          other[x] = std::max(other[x], std::min(first[x], correlation));
          first[x] = std::max(first[x], correlation);
        }
      });
}

// Computes the costs of all pixels on a plane. If there is only one neighbor, its correlation is
// used instead of the mean of two.
void Sweep::score(int plane) {
  const double depth = depth_of(plane);
  if (!mark_inside(depth)) return;
  std::vector<float> best(size(), 0.0F);
  std::vector<float> second(size(), 0.0F);
  for (const Neighbor& neighbor : neighbors_) compare(neighbor, depth, best.data(), second.data());
  const std::vector<float>& others = neighbors_.size() < 2 ? best : second;
  for (int y = first_row_; y < end_row_; ++y) {
    for (int x = first_column_; x < end_column_; ++x) {
      const std::size_t i = index(x, y);
      costs_.at(x, y)[static_cast<std::size_t>(plane)] = 1 - (best[i] + others[i]) / 2;
    }
  }
}

// Returns the depth of a pixel, or 0 if it is unknown. Only planes on which the pixel was compared
// are considered.
float Sweep::best_depth(int x, int y) const {
  const std::span<const float> costs = costs_.at(x, y);
  const std::span<const float> sums = sums_.at(x, y);
  std::size_t best = costs.size();
  for (std::size_t plane = 0; plane < costs.size(); ++plane)
    if (costs[plane] < 1 && (best == costs.size() || sums[plane] < sums[best])) best = plane;
  if (best == costs.size() || 1 - costs[best] < options_.least_correlation) return 0;
  const auto at = static_cast<double>(best);
  if (best == 0 || best + 1 == costs.size()) return static_cast<float>(depth_of(at));
  const float before = sums[best - 1];
  const float after = sums[best + 1];
  const float bend = before - 2 * sums[best] + after;
  const float offset = bend > 0 ? (before - after) / (2 * bend) : 0;
  return static_cast<float>(depth_of(at + std::clamp(offset, -0.5F, 0.5F)));
}

}  // namespace

DepthMap sweep_planes(const View& view, std::span<const View* const> neighbors,
                      const ValueGrid& hull, const PlaneSweepOptions& options) {
  return Sweep(view, neighbors, hull, options).run();
}

}  // namespace transformesh
