#include "tm/views/depth/depth_maps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

/// Views whose planes are swept before progress is reported again.
constexpr std::size_t views_at_once = 8;

/// Whether the other view has the point at about its depth, in one of the pixels around it.
bool is_found(const Vec3& point, const Projection& projection, const DepthMap& map,
              double tolerance) {
  const Vec3 q = projection.leftCols<3>() * point + projection.col(3);
  if (!(q.z() > 0)) return false;
  const double x = std::floor(q.x() / q.z());
  const double y = std::floor(q.y() / q.z());
  if (!(x >= 0 && y >= 0 && x + 1 < map.depth.width && y + 1 < map.depth.height)) return false;
  for (int i = 0; i < 4; ++i) {
    const float depth = map.depth.at(static_cast<int>(x) + i % 2, static_cast<int>(y) + i / 2);
    if (depth > 0 && std::abs(1 / depth - 1 / q.z()) <= tolerance * map.plane_gap) return true;
  }
  return false;
}

GrayImage agreed(std::size_t view, std::span<const View> views, std::span<const ViewPair> pairs,
                 std::span<const DepthMap> maps, const DepthMapsOptions& options) {
  std::vector<std::size_t> others;
  std::vector<Projection> projections;
  for (const ViewPair& pair : pairs) {
    if (pair.first != view) continue;
    others.push_back(pair.second);
    projections.push_back(views[pair.second].camera.projection());
  }
  const PinholeCamera& camera = views[view].camera;
  GrayImage depth = maps[view].depth;
  for (int y = 0; y < depth.height; ++y) {
    for (int x = 0; x < depth.width; ++x) {
      if (depth.at(x, y) == 0) continue;
      const Vec3 point = camera.center() + depth.at(x, y) * camera.ray(x, y);
      std::size_t count = 0;
      for (std::size_t i = 0; i < others.size(); ++i)
        count += is_found(point, projections[i], maps[others[i]], options.tolerance) ? 1 : 0;
      if (count < options.least_views) depth.at(x, y) = 0;
    }
  }
  return depth;
}

}  // namespace

std::vector<DepthMap> depth_maps(std::span<const View> views, std::span<const ViewPair> pairs,
                                 const ValueGrid& hull, const DepthMapsOptions& options,
                                 const Progress& progress) {
  std::vector<DepthMap> maps(views.size());
  for (std::size_t begin = 0; begin < views.size(); begin += views_at_once) {
    progress("sweep planes", static_cast<double>(begin) / static_cast<double>(views.size()));
    const std::size_t count = std::min(views_at_once, views.size() - begin);
    parallel_for(count, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = begin + first; i < begin + last; ++i) {
        std::vector<const View*> neighbors;
        for (const ViewPair& pair : pairs)
          if (pair.first == i) neighbors.push_back(&views[pair.second]);
        maps[i] = sweep_planes(views[i], neighbors, hull, options.sweep);
      }
    });
  }
  std::vector<GrayImage> depths(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) depths[i] = agreed(i, views, pairs, maps, options);
  });
  for (std::size_t i = 0; i < maps.size(); ++i) maps[i].depth = std::move(depths[i]);
  return maps;
}

}  // namespace transformesh
