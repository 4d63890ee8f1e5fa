#include "views/depth/dense_surface.h"

#include <algorithm>

#include "mesh/component_areas.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "views/depth/trim_border.h"
#include "views/depth/viewed_region.h"

namespace transformesh {
namespace {

/// Strips at the border of the surface are removed if they are narrower than twice this number of
/// edges. An edge is about half a grid cell long. In tests with objects on a table, strips one
/// pixel wide broke into pieces when the surface was refined later.
constexpr int fringe_rings = 6;

/// Resolution of the reconstruction: the factor by which photographs are shrunk, and the side of a
/// grid cell in input units.
struct Sizes {
  double scale = 1;
  double cell = 0;
};

Sizes sizes_of(std::span<const View> views, const Vec3& center, const DenseOptions& options) {
  int longest = 0;
  for (const View& view : views) longest = std::max({longest, view.image.width, view.image.height});
  const double pixel = pixel_size(cameras_of(views), center);
  Sizes sizes;
  sizes.scale = std::max(1.0, longest / options.size_px);
  if (options.cell) sizes.scale = std::max(1.0, *options.cell / (options.cell_px * pixel));
  sizes.cell = options.cell.value_or(options.cell_px * pixel * sizes.scale);
  return sizes;
}

std::vector<DepthMap> maps_of(std::span<const View> views, const ValueGrid& region, double scale,
                              const DenseOptions& options, const Progress& progress) {
  const std::vector<PinholeCamera> cameras = cameras_of(views);
  DepthMapsOptions maps = options.maps;
  maps.sweep.correlation.noise_variance /= scale * scale;
  const std::vector<ViewPair> pairs = choose_pairs(cameras, box_of(region).center(), options.pairs);
  return depth_maps(views, pairs, region, maps, progress);
}

void count_pixels(std::span<const View> views, std::span<const DepthMap> maps,
                  DenseSurface& result) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::vector<float>& depths = maps[i].depth.pixels;
    const auto known = static_cast<std::size_t>(
        std::count_if(depths.begin(), depths.end(), [](float depth) { return depth > 0; }));
    result.pixels += depths.size();
    result.consistent += known;
    if (known == 0) result.idle_views.push_back(views[i].name);
  }
}

/// Drops components with less than `share` times the area of the largest one. Returns the number of
/// dropped components.
std::size_t drop_crumbs(Mesh& mesh, double share) {
  const Components parts = connected_components(mesh);
  const std::vector<double> areas = component_areas(mesh, parts);
  if (areas.empty()) return 0;
  const double least = share * *std::max_element(areas.begin(), areas.end());
  std::vector<bool> keeps;
  for (const Index part : parts.of_face) keeps.push_back(areas[part] >= least);
  mesh = select_faces(mesh, keeps);
  return static_cast<std::size_t>(
      std::count_if(areas.begin(), areas.end(), [&](double area) { return area < least; }));
}

}  // namespace

DenseSurface dense_surface(std::span<const View> views, const DenseOptions& options,
                           const Progress& progress) {
  if (views.size() < 2) throw InputError("a surface needs at least two photographs");
  if (options.box && !(options.box->sizes().minCoeff() > 0))
    throw UsageError(
        "the box is empty: each coordinate of its first corner must be less than that of its "
        "second corner");
  const ValueGrid region = viewed_region(views, options.box);
  DenseSurface result;
  result.box = options.box.value_or(box_of(region));
  const Sizes sizes = sizes_of(views, result.box.center(), options);
  result.scale = sizes.scale;
  result.cell = sizes.cell;
  const std::vector<View> small = shrunk_photographs(views, sizes.scale);
  std::vector<DepthMap> maps = maps_of(small, region, sizes.scale, options, progress);
  count_pixels(small, maps, result);
  if (result.consistent == 0)
    throw GoalError(
        "no depth in any photograph is confirmed by other photographs: check the cameras");
  std::vector<DepthSurface> surfaces;
  for (std::size_t i = 0; i < maps.size(); ++i)
    surfaces.emplace_back(small[i].camera, std::move(maps[i]), options.maps.tolerance);
  const DistanceBlocks blocks =
      fuse_distances(result.box, sizes.cell, surfaces, options.fusion, progress);
  progress("march");
  result.mesh = march_blocks(blocks);
  trim_border(result.mesh, fringe_rings);
  result.dropped_components = drop_crumbs(result.mesh, options.crumbs);
  if (result.mesh.faces.empty())
    throw GoalError("the depths of the photographs form no surface: check the cameras");
  return result;
}

}  // namespace transformesh
