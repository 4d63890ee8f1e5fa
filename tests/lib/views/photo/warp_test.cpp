// Pixels of one view, compared with the pixels of another view at the same points of a ray-traced
// sphere.
#include "views/photo/warp.h"

#include <doctest/doctest.h>

#include "helpers/ball_photographs.h"

using namespace transformesh;

namespace {

struct Rows {
  std::vector<float> is_seen, reference, other, slope;
  explicit Rows(std::size_t size) : is_seen(size), reference(size), other(size), slope(size) {}
  WarpedRow row() { return {is_seen.data(), reference.data(), other.data(), slope.data()}; }
};

/// Returns the mean difference of both intensities, and the fraction of pixels that are visible in
/// the other view.
std::pair<double, double> compared(double angle_deg) {
  const Mesh mesh = test::icosphere(5);
  const std::vector<View> views{test::photograph(0, 1), test::photograph(angle_deg, 1)};
  const SeenViews seen(mesh, views, .3);
  VisibleSurface room;
  WarpRoom warp_room;
  const VisibleSurface& surface = seen.surface(0, room);
  const Warp warp(views[0], surface, views[1], seen.depths(1), .005, warp_room);
  double sum = 0;
  int shown = 0, all = 0;
  for (int y = surface.compared.first_row; y < surface.compared.end_row; ++y) {
    Rows rows(static_cast<std::size_t>(surface.compared.columns()));
    warp.row(y, Interpolation::catmull_rom, rows.row());
    for (std::size_t i = 0; i < rows.is_seen.size(); ++i) {
      const int x = surface.compared.first_column + static_cast<int>(i);
      const bool is_compared =
          surface.depth.at(x - surface.box.first_column, y - surface.box.first_row) > 0;
      all += is_compared ? 1 : 0;
      if (rows.is_seen[i] == 0) continue;
      ++shown;
      sum += std::abs(rows.reference[i] - rows.other[i]);
    }
  }
  REQUIRE(shown > 0);
  return {sum / shown, static_cast<double>(shown) / all};
}

}  // namespace

TEST_CASE("warping a view to itself does not change it") {
  const auto [difference, share] = compared(0);
  CHECK(difference < .5);
  CHECK(share > .95);
}

TEST_CASE("a warped view shows the same texture at visible points") {
  const auto [difference, share] = compared(22.5);
  CHECK(difference < 2);
  CHECK(share > .7);
  CHECK(share < 1);
}

TEST_CASE("a view from behind shows nothing of the front") {
  const Mesh mesh = test::icosphere(5);
  const std::vector<View> views{test::photograph(0, 1), test::photograph(180, 1)};
  const SeenViews seen(mesh, views, .3);
  VisibleSurface room;
  WarpRoom warp_room;
  const VisibleSurface& surface = seen.surface(0, room);
  const Warp warp(views[0], surface, views[1], seen.depths(1), .005, warp_room);
  for (int y = surface.compared.first_row; y < surface.compared.end_row; ++y) {
    Rows rows(static_cast<std::size_t>(surface.compared.columns()));
    warp.row(y, Interpolation::bilinear, rows.row());
    for (const float is_seen : rows.is_seen) CHECK(is_seen == 0);
  }
}
