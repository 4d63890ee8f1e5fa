#include "flow/analytic_fields.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/random.h"

using namespace transformesh;
using doctest::Approx;

namespace {

constexpr double pi = std::numbers::pi;

/// Returns the divergence by central differences.
double divergence(const VectorAt& field, const Vec3& p) {
  constexpr double step = 1e-5;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 offset = step * Vec3::Unit(axis);
    sum += (field(p + offset)[axis] - field(p - offset)[axis]) / (2 * step);
  }
  return sum;
}

/// Returns the end of a particle's path by the classic Runge-Kutta method.
Vec3 end_of_path(const AnalyticField& field, Vec3 p, double duration, int steps) {
  const double h = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    const Vec3 a = field(t)(p);
    const Vec3 b = field(t + h / 2)(p + h / 2 * a);
    const Vec3 c = field(t + h / 2)(p + h / 2 * b);
    const Vec3 d = field(t + h)(p + h * c);
    p += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return p;
}

}  // namespace

TEST_CASE("fields of incompressible flows have no divergence, and an expansion has three") {
  test::Random random(1);
  for (const char* name :
       {"rotation", "vortex", "deformation", "abc", "shear", "translation", "expansion"}) {
    CAPTURE(name);
    const AnalyticField field = analytic_field(name, {});
    REQUIRE(field);
    const double expected = std::string(name) == "expansion" ? 3 : 0;
    for (int i = 0; i < 100; ++i) {
      const VectorAt at = field(random.uniform(0, 3));
      CHECK(std::abs(divergence(at, random.point(-1, 2)) - expected) < 1e-8);
    }
  }
  CHECK(!analytic_field("no such field", {}));
}

TEST_CASE("reversing fields take particles back to their start after a period") {
  test::Random random(2);
  const AnalyticField deformation = analytic_field("deformation", {});
  const AnalyticField vortex = analytic_field("vortex", {});
  const AnalyticField quick = analytic_field("deformation", {.period = 1.5});
  double farthest = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 p = 0.5 * Vec3::Ones() + random.uniform(0, 0.4) * random.point(-1, 1).normalized();
    CHECK((end_of_path(deformation, p, 3, 2000) - p).norm() < 1e-8);
    CHECK((end_of_path(vortex, p, 8, 4000) - p).norm() < 1e-8);
    CHECK((end_of_path(quick, p, 1.5, 2000) - p).norm() < 1e-8);
    farthest = std::max(farthest, (end_of_path(deformation, p, 1.5, 1000) - p).norm());
  }
  CHECK(farthest > 0.2);
}

TEST_CASE("a rotation turns once in its period, about its axis") {
  const Vec3 center(1, 2, 3);
  const AnalyticField field =
      analytic_field("rotation", {.period = 2, .center = center, .direction = Vec3(0, 0, 5)});
  const Vec3 start = center + Vec3(1, 0, 7);
  CHECK((end_of_path(field, start, 2, 1000) - start).norm() < 1e-9);
  CHECK((end_of_path(field, start, 0.5, 1000) - (center + Vec3(0, 1, 7))).norm() < 1e-9);
}

TEST_CASE("fields have the values of their formulas") {
  const Vec3 p(0.1, 0.3, 0.65);
  const auto s = [](double x) { return std::sin(pi * x); };
  const auto S = [](double x) { return std::sin(2 * pi * x); };
  const auto C = [](double x) { return std::cos(2 * pi * x); };
  const double back = std::cos(pi * 0.7 / 3);
  const Vec3 deformation(2 * s(p.x()) * s(p.x()) * S(p.y()) * S(p.z()) * back,
                         -S(p.x()) * s(p.y()) * s(p.y()) * S(p.z()) * back,
                         -S(p.x()) * S(p.y()) * s(p.z()) * s(p.z()) * back);
  CHECK((analytic_field("deformation", {})(0.7)(p)-deformation).norm() < 1e-14);
  const Vec3 vortex(-s(p.x()) * s(p.x()) * S(p.y()), S(p.x()) * s(p.y()) * s(p.y()), 0);
  CHECK((analytic_field("vortex", {})(0)(p)-vortex).norm() < 1e-14);
  const double a = std::sqrt(3), b = std::sqrt(2);
  const Vec3 abc(a * S(p.z()) + C(p.y()), b * S(p.x()) + a * C(p.z()), S(p.y()) + b * C(p.x()));
  CHECK((analytic_field("abc", {})(9)(p)-abc).norm() < 1e-14);
  CHECK(analytic_field("shear", {})(0)(p).isApprox(Vec3(0.15, 0, 0)));
  CHECK(analytic_field("translation", {.direction = Vec3(0, 3, 4)})(0)(p).isApprox(
      Vec3(0, 0.6, 0.8)));
}

TEST_CASE("an expansion makes lengths grow by e per time") {
  const AnalyticField field = analytic_field("expansion", {.center = Vec3(1, 1, 1)});
  const Vec3 end = end_of_path(field, Vec3(2, 1, 1), 1, 200);
  CHECK(end.x() - 1 == Approx(std::numbers::e).epsilon(1e-8));
}
