#include "flow/sampled_grid.h"

#include <doctest/doctest.h>

#include "flow/analytic_fields.h"
#include "helpers/random.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// A grid over the unit cube with the values of a function.
template <class Function>
FlowGrid grid_of(std::size_t nodes, const Function& value) {
  FlowGrid grid;
  grid.size = {nodes, nodes + 1, nodes + 2};
  for (int axis = 0; axis < 3; ++axis)
    grid.spacing[axis] = 1.0 / static_cast<double>(grid.size[axis] - 1);
  for (std::size_t z = 0; z < grid.size[2]; ++z)
    for (std::size_t y = 0; y < grid.size[1]; ++y)
      for (std::size_t x = 0; x < grid.size[0]; ++x) {
        const Vec3 at = value(Vec3(x, y, z).cwiseProduct(grid.spacing));
        grid.values.insert(grid.values.end(), {at.x(), at.y(), at.z()});
      }
  return grid;
}

double largest_error(std::size_t nodes) {
  const VectorAt field = analytic_field("deformation", {})(0.4);
  const GridSeries series({grid_of(nodes, field)}, 3);
  test::Random random(3);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.point(0, 1);
    worst = std::max(worst, (value_at(series.around(0), p).value - field(p)).norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("a sampled field converges to the analytic one with the square of the spacing") {
  const double coarse = largest_error(20), fine = largest_error(39);
  CHECK(fine < 0.02);
  CHECK(coarse / fine > 3.3);
}

TEST_CASE("trilinear functions are exact between nodes, and far points take the nearest value") {
  const auto function = [](const Vec3& p) -> Vec3 {
    return {p.x() * p.y() * p.z(), 1 - p.x() + 2 * p.y() * p.z(), p.z()};
  };
  const GridSeries series({grid_of(4, function)}, 3);
  test::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = random.point(-0.5, 1.5);
    const Vec3 nearest = p.cwiseMax(Vec3::Zero()).cwiseMin(Vec3::Ones());
    const GridValue found = value_at(series.around(0), p);
    CHECK((found.value - function(nearest)).norm() < 1e-13);
    CHECK(found.is_outside == (p != nearest));
  }
  CHECK(!value_at(series.around(0), Vec3(1 + 1e-12, 0, 1)).is_outside);
}

TEST_CASE("values are linear in time, and times outside are those of the nearest grid") {
  std::vector<FlowGrid> grids(3);
  const std::vector<double> times{2, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    grids[i].values = {times[i] * times[i], 0, 0};
    grids[i].time = times[i];
  }
  const GridSeries series(grids, 3);
  const auto at = [&](double time) {
    return value_at(series.around(time), Vec3::Zero()).value.x();
  };
  CHECK(at(0.25) == Approx(0.25));
  CHECK(at(1) == 1);
  CHECK(at(1.5) == Approx(2.5));
  CHECK(at(-3) == 0);
  CHECK(at(7) == 4);
  CHECK(series.around(-3).is_outside);
  CHECK(series.around(7).is_outside);
  CHECK(!series.around(0).is_outside);
  CHECK(!series.around(2).is_outside);
  // A layer of a single node has no thickness, so no point is outside of it.
  CHECK(!value_at(series.around(0), Vec3(9, 9, 9)).is_outside);
}

TEST_CASE("inconsistent series of grids are refused") {
  FlowGrid grid;
  grid.values = {1, 2, 3};
  CHECK_THROWS_AS(GridSeries({}, 3), UsageError);
  CHECK_THROWS_AS(GridSeries({grid}, 1), UsageError);
  CHECK_THROWS_AS(GridSeries({grid, grid}, 3), InputError);  // grids without times
  grid.time = 1;
  CHECK_THROWS_AS(GridSeries({grid, grid}, 3), InputError);  // grids with equal times
  grid.spacing.y() = 0;
  CHECK_THROWS_AS(GridSeries({grid}, 3), UsageError);
  grid.spacing.y() = 1;
  grid.size[0] = 2;
  CHECK_THROWS_AS(GridSeries({grid}, 3), UsageError);
  grid.size[0] = std::size_t{1} << 40;
  CHECK_THROWS_AS(GridSeries({grid}, 3), UsageError);
}
