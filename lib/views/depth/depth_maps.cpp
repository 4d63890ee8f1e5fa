#include "views/depth/depth_maps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "raster/camera.h"
#include "support/parallel.h"
#include "views/cameras/view.h"

namespace transformesh {
namespace {

/// Number of views whose depth maps are computed before progress is reported again.
constexpr std::size_t views_at_once = 8;

/// True if another view confirms `point`: its depth map `map` has approximately the depth of the
/// point at the pixel to which the point projects.
bool is_found(const Vec3& point, const Projection& projection, const DepthMap& map,
              double tolerance) {
  const Vec3 q = projection.leftCols<3>() * point + projection.col(3);
  if (!(q.z() > 0)) return false;
  const double x = std::floor(q.x() / q.z() + 0.5);
  const double y = std::floor(q.y() / q.z() + 0.5);
  if (!(x >= 0 && y >= 0 && x < map.depth.width && y < map.depth.height)) return false;
  const float depth = map.depth.at(static_cast<int>(x), static_cast<int>(y));
  return depth > 0 && std::abs(1 / depth - 1 / q.z()) <= tolerance * map.plane_gap;
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

/// Finds patches of a depth map: sets of connected pixels. Adjacent pixels are connected if their
/// inverse depths differ by less than `tolerance` times the spacing of the plane sweep's planes.
class Islands {
 public:
  Islands(DepthMap& map, double tolerance)
      : depth_(map.depth), gap_(tolerance * map.plane_gap), is_met_(depth_.pixels.size(), 0) {}

  void drop_those_below(std::size_t pixels) {
    for (std::size_t first = 0; first < is_met_.size(); ++first) {
      if (depth_.pixels[first] == 0 || is_met_[first]) continue;
      const std::vector<std::size_t> island = island_of(first);
      if (island.size() >= pixels) continue;
      for (const std::size_t pixel : island) depth_.pixels[pixel] = 0;
    }
  }

 private:
  std::vector<std::size_t> island_of(std::size_t first) {
    const auto width = static_cast<std::size_t>(depth_.width);
    std::vector<std::size_t> island{first};
    is_met_[first] = 1;
    for (std::size_t k = 0; k < island.size(); ++k) {
      const std::size_t pixel = island[k];
      if (pixel % width > 0) meet(pixel, pixel - 1, island);
      if (pixel >= width) meet(pixel, pixel - width, island);
      if (pixel % width + 1 < width) meet(pixel, pixel + 1, island);
      if (pixel + width < is_met_.size()) meet(pixel, pixel + width, island);
    }
    return island;
  }

  void meet(std::size_t from, std::size_t to, std::vector<std::size_t>& island) {
    const float here = depth_.pixels[from], there = depth_.pixels[to];
    if (is_met_[to] || there <= 0 || std::abs(1 / here - 1 / there) > gap_) return;
    is_met_[to] = 1;
    island.push_back(to);
  }

  GrayImage& depth_;
  double gap_;
  std::vector<char> is_met_;
};

}  // namespace

std::vector<View> shrunk_photographs(std::span<const View> views, double scale) {
  std::vector<View> result(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      result[i] = at_scale({views[i].name, views[i].camera, views[i].image, {}}, scale);
  });
  return result;
}

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
  for (std::size_t i = 0; i < maps.size(); ++i) {
    maps[i].depth = std::move(depths[i]);
    Islands(maps[i], options.tolerance).drop_those_below(options.least_pixels);
  }
  return maps;
}

}  // namespace transformesh
