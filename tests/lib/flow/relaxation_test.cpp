#include "flow/relaxation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "transformesh/errors.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Equations of two unknowns between fixed vertices: m y' = m b - k y for each of them.
struct Pair {
  Unknowns unknowns{{no_index, 0, no_index, 1}, {1, 3}};
  Eigen::Vector2d masses{2, 0.5};
  Relaxation::Matrix stiffness{2, 2};

  Pair(double first, double second) {
    stiffness.insert(0, 0) = first;
    stiffness.insert(1, 1) = second;
  }
  std::vector<double> after(double span, const std::vector<double>& rates) const {
    return Relaxation(unknowns, masses, stiffness, span).after(rates);
  }
};

/// Returns the solution of y' = rate - decay y.
double exact(double rate, double decay, double span) {
  return rate / decay * (1 - std::exp(-decay * span));
}

}  // namespace

TEST_CASE("short steps have errors of third order, and fixed vertices stay") {
  const Pair pair(6, 1);  // decays of 3 and 2
  const auto error = [&](double span) {
    const std::vector<double> y = pair.after(span, {9, 1, 9, -4});
    CHECK(y[0] == 0);
    CHECK(y[2] == 0);
    return std::abs(y[1] - exact(1, 3, span)) + std::abs(y[3] - exact(-4, 2, span));
  };
  CHECK(error(0.1) < 1e-3);
  CHECK(std::log2(error(0.02) / error(0.01)) == Approx(3).epsilon(0.03));
}

TEST_CASE("after a long step the solution is the equilibrium") {
  const std::vector<double> y = Pair(6, 1).after(1e9, {0, 1, 0, -4});
  CHECK(y[1] == Approx(1.0 / 3).epsilon(1e-6));
  CHECK(y[3] == Approx(-2).epsilon(1e-6));
}

TEST_CASE("vectors relax as their coordinates do, and unknowns without stiffness go straight on") {
  const Pair pair(6, 0);
  const std::vector<Vec3> rates{Vec3(9, 9, 9), Vec3(1, 2, 3), Vec3::Zero(), Vec3(-4, 0, 4)};
  const std::vector<Vec3> y =
      Relaxation(pair.unknowns, pair.masses, pair.stiffness, 0.5).after(rates);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> along;
    for (const Vec3& rate : rates) along.push_back(rate[axis]);
    const std::vector<double> alone = pair.after(0.5, along);
    for (std::size_t v = 0; v < rates.size(); ++v) CHECK(y[v][axis] == alone[v]);
  }
  CHECK(y[3] == Vec3(-2, 0, 2));
}

TEST_CASE("equations without a solution in double precision are refused") {
  CHECK_THROWS_AS(Pair(6, 1).after(1, {0, 1e308, 0, 1e308}), GoalError);
}
