#include "views/depth/depth_fusion.h"

#include <doctest/doctest.h>

#include "helpers/ball_photographs.h"
#include "helpers/pocket_photographs.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/depth/opened_hull.h"
#include "views/hull/hull_values.h"

using namespace transformesh;

namespace {

const test::PocketViews& scene() {
  static const test::PocketViews scene = test::pocket_views();
  return scene;
}

ValueGrid hull_of_block() { return hull_values(scene().views, {.edge = 0.05}); }

std::vector<DepthMap> true_maps() {
  std::vector<DepthMap> maps;
  for (const GrayImage& depth : scene().depths) maps.push_back({depth, 0.001});
  return maps;
}

double signed_gap(const Vec3& low, const Vec3& high, const Vec3& point) {
  return (low - point).cwiseMax(point - high).maxCoeff();
}

/// Counts nodes farther than `slack` from the surface of the block that are open although the block
/// is solid there, or the reverse.
std::size_t wrong_nodes(const ValueGrid& grid, double slack) {
  std::size_t count = 0;
  for (std::size_t z = 0; z < grid.nodes[2]; ++z) {
    for (std::size_t y = 0; y < grid.nodes[1]; ++y) {
      for (std::size_t x = 0; x < grid.nodes[0]; ++x) {
        const Vec3 point =
            grid.origin + grid.spacing * Vec3(static_cast<double>(x), static_cast<double>(y),
                                              static_cast<double>(z));
        const double in_block = signed_gap(-test::block_half, test::block_half, point);
        const double in_pocket =
            signed_gap(Vec3(-test::pocket_half, -test::pocket_half, test::pocket_floor),
                       Vec3(test::pocket_half, test::pocket_half, 100), point);
        const double outside = std::max(in_block, -in_pocket);
        if (std::abs(outside) < slack) continue;
        const bool is_open = grid.values[grid.index(x, y, z)] >= 0;
        count += is_open != (outside > 0) ? 1 : 0;
      }
    }
  }
  return count;
}

}  // namespace

TEST_CASE("depths open the pocket, and nothing else") {
  const ValueGrid hull = hull_of_block();
  const ValueGrid opened = fuse_depths(hull, scene().views, true_maps());
  CHECK(wrong_nodes(hull, 0.15) > 3000);
  CHECK(wrong_nodes(opened, 0.15) < 30);
  for (std::size_t i = 0; i < hull.values.size(); ++i) CHECK(opened.values[i] >= hull.values[i]);
}

TEST_CASE("without depths the hull stays as it is, and a few wrong ones open nothing") {
  const ValueGrid hull = hull_of_block();
  std::vector<DepthMap> maps;
  const auto wrong_at = [&](std::size_t every, double prior) {
    maps = true_maps();
    for (DepthMap& map : maps)  // these rays pass through the surface
      for (std::size_t i = 0; i < map.depth.pixels.size(); i += every)
        if (map.depth.pixels[i] > 0) map.depth.pixels[i] += 0.6F;
    return wrong_nodes(fuse_depths(hull, scene().views, maps, {.prior = prior}), 0.15);
  };
  CHECK(wrong_at(61, DepthFusionOptions().prior) < 60);
  CHECK(wrong_at(37, 1) < 60);
  for (DepthMap& map : maps) std::fill(map.depth.pixels.begin(), map.depth.pixels.end(), 0.0F);
  CHECK(fuse_depths(hull, scene().views, maps).values == hull.values);
}

TEST_CASE("a surface is continued smoothly in a gap that no view shows") {
  const ValueGrid hull = hull_of_block();
  std::vector<DepthMap> maps = true_maps();
  for (std::size_t v = 0; v < maps.size(); ++v) {
    GrayImage& depth = maps[v].depth;
    const PinholeCamera& camera = scene().views[v].camera;
    for (int y = 0; y < depth.height; ++y)
      for (int x = 0; x < depth.width; ++x) {
        const Vec3 point = camera.center() + depth.at(x, y) * camera.ray(x, y);
        const bool is_deep = point.head<2>().cwiseAbs().maxCoeff() < 0.505 && point.z() < 0.3;
        if (is_deep && point.z() > 0) depth.at(x, y) = 0;
      }
  }
  // Rays that end in the lower third of the pocket give no evidence.
  const std::size_t solid =
      wrong_nodes(fuse_depths(hull, scene().views, maps, {.rounds = 0}), 0.05);
  const std::size_t smooth = wrong_nodes(fuse_depths(hull, scene().views, maps), 0.05);
  MESSAGE(solid, " wrong nodes, by diffusion ", smooth);
  CHECK(solid > 100);
  CHECK(static_cast<double>(smooth) < 0.8 * static_cast<double>(solid));
}

TEST_CASE("photographs open a pocket that the hull closes, for any number of threads") {
  const double of_hull = volume(visual_hull(scene().views, {.resolution = 60}).mesh);
  const double of_truth = test::block_volume - test::pocket_volume;
  CHECK(of_hull > 1.2 * of_truth);
  const std::optional<OpenedHull> opened = opened_hull(scene().views);
  REQUIRE(opened);
  CHECK(volume(opened->mesh) == doctest::Approx(of_truth).epsilon(0.06));
  const ThreadLimit limit(1);
  CHECK(opened_hull(scene().views)->mesh.positions == opened->mesh.positions);
}

TEST_CASE("photographs of other places open nothing") {
  std::vector<View> views = scene().views;
  for (std::size_t v = 0; v < views.size(); ++v)
    views[v].image = scene().views[(v * 7 + 3) % views.size()].image;
  CHECK_FALSE(opened_hull(views));
  // The opened hull is refused because of the silhouettes.
  OpenedHullOptions options;
  options.most_agreement_lost = 1;
  CHECK(opened_hull(views, options));
}

TEST_CASE("a hull without hollows is not opened") { CHECK_FALSE(opened_hull(test::ring(1, true))); }
