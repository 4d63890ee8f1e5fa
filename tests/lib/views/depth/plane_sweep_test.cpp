#include "views/depth/plane_sweep.h"

#include <doctest/doctest.h>

#include "helpers/pocket_photographs.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/depth/depth_maps.h"
#include "views/hull/hull_values.h"

using namespace transformesh;

namespace {

struct Scene {
  test::PocketViews photographed = test::pocket_views();
  std::vector<View>& views = photographed.views;
  ValueGrid hull = hull_values(views, {.edge = 0.04});
  std::vector<ViewPair> pairs = choose_pairs(cameras_of(views), Vec3::Zero());

  DepthMap swept(std::size_t view, const PlaneSweepOptions& options = {}) const {
    std::vector<const View*> neighbors;
    for (const ViewPair& pair : pairs)
      if (pair.first == view) neighbors.push_back(&views[pair.second]);
    return sweep_planes(views[view], neighbors, hull, options);
  }
};

const Scene& scene() {
  static const Scene scene;
  return scene;
}

const std::vector<DepthMap>& agreed_maps() {
  static const std::vector<DepthMap> maps = depth_maps(scene().views, scene().pairs, scene().hull);
  return maps;
}

/// Returns the views of the scene, each with the photograph of another view.
std::vector<View> views_of_other_places() {
  std::vector<View> views = scene().views;
  for (std::size_t v = 0; v < views.size(); ++v)
    views[v].image = scene().views[(v * 7 + 3) % views.size()].image;
  return views;
}

struct Known {
  double share = 0;  ///< fraction of the pixels that show the block
  // fraction of these that are correct to within one pixel in the nearest neighbor, 0.06
  double right = 0;
};

template <typename Chosen>
Known known_of(const GrayImage& depth, const GrayImage& truth, const Chosen& is_chosen) {
  double seen = 0, known = 0, right = 0;
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      if (!is_chosen(x, y)) continue;
      ++seen;
      if (depth.at(x, y) == 0) continue;
      ++known;
      right += std::abs(depth.at(x, y) - truth.at(x, y)) < 0.06 ? 1 : 0;
    }
  }
  REQUIRE(seen > 100);
  return {known / seen, known > 0 ? right / known : 0};
}

}  // namespace

TEST_CASE("one view's depths are those of the block, down to the floor of its pocket") {
  const GrayImage& truth = scene().photographed.depths[0];
  const PinholeCamera& camera = scene().views[0].camera;
  const DepthMap map = scene().swept(0);
  const Known all = known_of(map.depth, truth, [&](int x, int y) { return truth.at(x, y) > 0; });
  CHECK(all.share > 0.9);
  CHECK(all.right > 0.8);
  // The hull is at least 0.6 in front of the floor.
  const auto is_floor = [&](int x, int y) {
    if (truth.at(x, y) == 0) return false;
    const Vec3 point = camera.center() + truth.at(x, y) * camera.ray(x, y);
    return std::abs(point.z() - test::pocket_floor) < 1e-3 &&
           point.head<2>().cwiseAbs().maxCoeff() < 0.45;
  };
  const Known floor = known_of(map.depth, truth, is_floor);
  CHECK(floor.share > 0.9);
  CHECK(floor.right > 0.75);
  const Known agreed = known_of(agreed_maps()[0].depth, truth, is_floor);
  CHECK(agreed.share > 0.7);
  CHECK(agreed.right > 0.8);
  for (std::size_t i = 0; i < truth.pixels.size(); ++i)
    if (map.depth.pixels[i] > 0) CHECK(map.depth.pixels[i] > 8);
}

TEST_CASE("a stricter limit leaves fewer depths, and these are right") {
  DepthMapsOptions strict;
  strict.sweep.least_correlation = 0.6;
  const GrayImage& truth = scene().photographed.depths[0];
  const DepthMap map = scene().swept(0, strict.sweep);
  const Known all = known_of(map.depth, truth, [&](int x, int y) { return truth.at(x, y) > 0; });
  CHECK(all.share > 0.6);
  CHECK(all.right > 0.85);
  const auto known = [](const DepthMap& depths) {
    return std::count_if(depths.depth.pixels.begin(), depths.depth.pixels.end(),
                         [](float depth) { return depth > 0; });
  };
  const auto true_maps = depth_maps(scene().views, scene().pairs, scene().hull, strict);
  const auto wrong_maps = depth_maps(views_of_other_places(), scene().pairs, scene().hull, strict);
  CHECK(known(wrong_maps[0]) < known(true_maps[0]) / 5);
}

TEST_CASE("without texture, neighbors or a hull there are no depths") {
  const auto is_empty = [](const DepthMap& map) {
    return std::all_of(map.depth.pixels.begin(), map.depth.pixels.end(),
                       [](float depth) { return depth == 0; });
  };
  const View& view = scene().views[0];
  CHECK(is_empty(sweep_planes(view, {}, scene().hull)));
  ValueGrid nothing = scene().hull;
  for (float& value : nothing.values) value = 1;
  const View* const neighbor = &scene().views[1];
  CHECK(is_empty(sweep_planes(view, {&neighbor, 1}, nothing)));
  View blank = view;
  for (int y = 0; y < blank.image.height; ++y)
    for (int x = 0; x < blank.image.width; ++x) blank.image.at(x, y) = 100;
  CHECK(is_empty(sweep_planes(blank, {&neighbor, 1}, scene().hull)));
}

TEST_CASE("depths that other views do not confirm are removed, and the others stay") {
  const Scene& true_scene = scene();
  const auto count = [](const DepthMap& map) {
    return std::count_if(map.depth.pixels.begin(), map.depth.pixels.end(),
                         [](float depth) { return depth > 0; });
  };
  const std::vector<DepthMap>& maps = agreed_maps();
  CHECK(static_cast<double>(count(maps[0])) >
        0.7 * static_cast<double>(count(true_scene.swept(0))));
  const GrayImage& truth = true_scene.photographed.depths[0];
  CHECK(known_of(maps[0].depth, truth, [&](int x, int y) { return truth.at(x, y) > 0; }).right >
        0.88);
  const std::vector<DepthMap> wrong =
      depth_maps(views_of_other_places(), true_scene.pairs, true_scene.hull);
  CHECK(count(wrong[0]) < count(maps[0]) / 3);
}
