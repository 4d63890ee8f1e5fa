// Rules of agreement between depth maps, on photographs of a block with a pocket.
#include "views/depth/depth_maps.h"

#include <doctest/doctest.h>

#include "helpers/pocket_photographs.h"
#include "support/parallel.h"
#include "transformesh/hull.h"
#include "views/hull/hull_values.h"

using namespace transformesh;

namespace {

struct Scene {
  test::PocketViews photographed = test::pocket_views();
  ValueGrid hull = hull_values(photographed.views, {.edge = 0.08});
  std::vector<ViewPair> pairs = choose_pairs(cameras_of(photographed.views), Vec3::Zero());

  std::vector<DepthMap> maps(const DepthMapsOptions& options = {}) const {
    return depth_maps(photographed.views, pairs, hull, options);
  }
};

const Scene& scene() {
  static const Scene scene;
  return scene;
}

std::size_t known_in(const std::vector<DepthMap>& maps) {
  std::size_t count = 0;
  for (const DepthMap& map : maps)
    for (const float depth : map.depth.pixels) count += depth > 0 ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("consistent depths are an unchanged subset of each view's depths") {
  DepthMapsOptions alone;
  alone.least_views = 0;
  alone.least_pixels = 1;
  const std::vector<DepthMap> found = scene().maps(alone), agreed = scene().maps();
  REQUIRE(found.size() == scene().photographed.views.size());
  CHECK(known_in(agreed) > 0);
  CHECK(known_in(agreed) < known_in(found));
  for (std::size_t v = 0; v < found.size(); ++v)
    for (std::size_t i = 0; i < found[v].depth.pixels.size(); ++i)
      if (agreed[v].depth.pixels[i] > 0)
        REQUIRE(agreed[v].depth.pixels[i] == found[v].depth.pixels[i]);
}

TEST_CASE("more views that must agree, and larger patches, leave less") {
  const std::size_t usual = known_in(scene().maps());
  DepthMapsOptions options;
  options.least_views = 3;
  CHECK(known_in(scene().maps(options)) < usual);
  options = {};
  options.least_pixels = 1000000;
  CHECK(known_in(scene().maps(options)) == 0);
}

TEST_CASE("maps do not depend on the number of threads") {
  const std::vector<DepthMap> expected = scene().maps();
  const ThreadLimit limit(1);
  const std::vector<DepthMap> maps = scene().maps();
  for (std::size_t v = 0; v < maps.size(); ++v)
    CHECK(maps[v].depth.pixels == expected[v].depth.pixels);
}
