#include "helpers/revolution_flow.h"

#include <doctest/doctest.h>

using namespace transformesh::test;
using doctest::Approx;

namespace {

/// Returns the largest deviation of the profile of a shrinking unit sphere from the exact radius at
/// time 0.2.
double sphere_error(int count) {
  RevolutionFlow flow(ellipsoid_profile(1, 1, count));
  flow.advance_to(0.2);
  double worst = 0;
  for (const ProfilePoint& p : flow.points())
    worst = std::max(worst, std::abs(p.norm() - std::sqrt(1 - 4 * 0.2)));
  return worst;
}

}  // namespace

TEST_CASE("the solver for surfaces of revolution has the radius of a shrinking sphere") {
  CHECK(sphere_error(101) < 2e-4);
  CHECK(sphere_error(51) / sphere_error(101) > 3.4);  // nearly 4, because the error is of order 2
}

TEST_CASE("a ring that is far from the axis collapses as a cylinder does") {
  CHECK(ring_collapse_time(torus_profile(1000, 0.4, 100)) == Approx(0.08).epsilon(2e-3));
  CHECK(ring_collapse_time(torus_profile(1000, 0.4, 200)) == Approx(0.08).epsilon(5e-4));
}

TEST_CASE("times of collapse and pinching converge with the number of points") {
  const auto converges = [](const auto& time_of, int points) {
    const double coarse = time_of(points), middle = time_of(2 * points), fine = time_of(4 * points);
    CAPTURE(fine);
    CHECK(std::abs(middle - fine) < std::max(0.35 * std::abs(coarse - middle), 1e-6 * fine));
    CHECK(std::abs(middle - fine) < 1e-3 * fine);
    return fine;
  };
  const double ring =
      converges([](int n) { return ring_collapse_time(torus_profile(1, 0.4, n)); }, 100);
  // The profile of the ring is a circle with radius r = 0.4, R = 1 away from the axis. Its area
  // shrinks at the rate 2 pi (2 - R / sqrt(R^2 - r^2)), which grows from 2 pi * 0.909 to 2 pi.
  CHECK(ring > 0.08);
  CHECK(ring < 0.08 / 0.9089);
  MESSAGE("the ring collapses at ", ring);
  const double neck =
      converges([](int n) { return pinch_time(dumbbell_profile(0.15, n + 1)); }, 200);
  MESSAGE("the neck pinches at ", neck);
  CHECK(neck > 0.01125);  // lifetime of a cylinder of radius 0.15; the balls prolong it
}

TEST_CASE("an ellipsoid becomes rounder, and vanishes between its inner and outer sphere") {
  RevolutionFlow flow(ellipsoid_profile(0.5, 1, 201));
  const auto aspect = [&] {
    return flow.points().back().y() / flow.radius(flow.points().size() / 2);
  };
  CHECK(aspect() == Approx(2));
  double last = aspect();
  for (const double time : {0.02, 0.04, 0.06, 0.08}) {
    flow.advance_to(time);
    CHECK(aspect() < last);
    last = aspect();
  }
  CHECK(flow.profile_area() > 0);
}

TEST_CASE("volumes are those of the closed forms") {
  const double pi = std::numbers::pi;
  CHECK(RevolutionFlow(ellipsoid_profile(0.5, 1, 401)).volume() == Approx(pi / 3).epsilon(1e-4));
  CHECK(RevolutionFlow(torus_profile(1, 0.4, 400)).volume() ==
        Approx(2 * pi * pi * 0.16).epsilon(1e-4));
}
