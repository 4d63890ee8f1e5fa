#include "views/depth/viewed_region.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "raster/camera.h"
#include "support/parallel.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Number of grid cells along the longest side. The region only bounds the depths of a plane sweep.
/// Smaller cells would bound them more tightly, which only saves a few planes.
constexpr double cells = 96;
/// Radius of the default region, as a fraction of the median distance of the cameras. A larger
/// radius includes the space between and behind cameras. Planes there are so near to cameras that a
/// sweep needs many of them.
constexpr double radius_share = 0.6;

double median_distance(std::span<const PinholeCamera> cameras, const Vec3& center) {
  std::vector<double> distances;
  for (const PinholeCamera& camera : cameras)
    distances.push_back((camera.center() - center).norm());
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  return distances[distances.size() / 2];
}

bool shows(const View& view, const Projection& projection, const Vec3& point) {
  const Vec3 q = projection.leftCols<3>() * point + projection.col(3);
  if (!(q.z() > 0)) return false;
  const double x = q.x() / q.z(), y = q.y() / q.z();
  return x >= 0 && y >= 0 && x <= view.image.width - 1 && y <= view.image.height - 1;
}

ValueGrid grid_of(const Box& box) {
  ValueGrid grid;
  const Vec3 size = box.max() - box.min();
  grid.spacing = size.maxCoeff() / cells;
  grid.origin = box.min();
  for (int axis = 0; axis < 3; ++axis)
    grid.nodes[static_cast<std::size_t>(axis)] =
        static_cast<std::size_t>(size[axis] / grid.spacing + 0.5) + 1;
  grid.values.assign(grid.nodes[0] * grid.nodes[1] * grid.nodes[2],
                     static_cast<float>(2 * grid.spacing));
  return grid;
}

/// A ball, or all of space if the radius is infinite.
struct Ball {
  Vec3 center = Vec3::Zero();
  double radius = std::numeric_limits<double>::infinity();

  bool contains(const Vec3& point) const { return (point - center).norm() <= radius; }
};

void mark(ValueGrid& grid, std::span<const View> views, const Ball& ball) {
  const std::size_t least = std::min<std::size_t>(3, views.size());
  std::vector<Projection> projections;
  for (const View& view : views) projections.push_back(view.camera.projection());
  parallel_for(grid.nodes[2], 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t z = first; z < last; ++z)
      for (std::size_t y = 0; y < grid.nodes[1]; ++y)
        for (std::size_t x = 0; x < grid.nodes[0]; ++x) {
          const Vec3 point = grid.position(x, y, z);
          if (!ball.contains(point)) continue;
          std::size_t count = 0;
          for (std::size_t i = 0; i < views.size() && count < least; ++i)
            count += shows(views[i], projections[i], point) ? 1 : 0;
          if (count >= least) grid.values[grid.index(x, y, z)] = static_cast<float>(-grid.spacing);
        }
  });
}

}  // namespace

ValueGrid viewed_region(std::span<const View> views, const std::optional<Box>& box) {
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  Ball ball;
  Box around = box.value_or(Box());
  if (!box) {
    ball.center = viewed_point(cameras);
    ball.radius = radius_share * median_distance(cameras, ball.center);
    around =
        Box(ball.center - Vec3::Constant(ball.radius), ball.center + Vec3::Constant(ball.radius));
  }
  ValueGrid grid = grid_of(around);
  mark(grid, views, ball);
  if (std::none_of(grid.values.begin(), grid.values.end(), [](float v) { return v < 0; }))
    throw InputError(
        "no point of the region to search is visible in enough views (three, or both of two): "
        "check the cameras, or give another box");
  return grid;
}

std::optional<Box> box_of_points(std::vector<Vec3> points) {
  // Least number of points, because boxes of fewer points are unreliable.
  constexpr std::size_t least_points = 100;
  // The smallest and the largest 1 / `outliers` of the coordinates along each axis are ignored as
  // outliers.
  constexpr std::size_t outliers = 50;
  // Margin as a fraction of the size, because parts of objects lack points.
  constexpr double margin = 0.1;
  if (points.size() < least_points) return std::nullopt;
  Box box(Vec3::Zero());
  const auto end = static_cast<std::ptrdiff_t>(points.size() / outliers);
  for (int axis = 0; axis < 3; ++axis) {
    const auto is_before = [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; };
    std::nth_element(points.begin(), points.begin() + end, points.end(), is_before);
    box.min()[axis] = points[static_cast<std::size_t>(end)][axis];
    std::nth_element(points.begin(), points.end() - 1 - end, points.end(), is_before);
    box.max()[axis] = (*(points.end() - 1 - end))[axis];
  }
  const Vec3 more = margin * (box.max() - box.min());
  return Box(box.min() - more, box.max() + more);
}

Box box_of(const ValueGrid& region) {
  Box box;
  for (std::size_t z = 0; z < region.nodes[2]; ++z)
    for (std::size_t y = 0; y < region.nodes[1]; ++y)
      for (std::size_t x = 0; x < region.nodes[0]; ++x)
        if (region.values[region.index(x, y, z)] < 0) box.extend(region.position(x, y, z));
  const Vec3 margin = Vec3::Constant(region.spacing);
  return {box.min() - margin, box.max() + margin};
}

}  // namespace transformesh
