#include "flow/analytic_fields.h"

#include <cmath>
#include <numbers>

#include "support/elementary/trigonometric.h"

namespace transformesh {
namespace {

using std::numbers::pi;

/// The values sin(pi x) and cos(pi x) of a coordinate x.
struct HalfWave {
  double sine;
  double cosine;

  explicit HalfWave(double x) : sine(elementary::sin(pi * x)), cosine(elementary::cos(pi * x)) {}
  double squared_sine() const { return sine * sine; }
  double sine_of_twice() const { return 2 * sine * cosine; }
  double cosine_of_twice() const { return 1 - 2 * sine * sine; }
};

/// Returns cos(pi time / period). A velocity field multiplied by this factor brings every particle
/// back to its start after `period`.
double reversal(double time, double period) { return elementary::cos(pi * time / period); }

Vec3 vortex_at(const Vec3& p) {
  const HalfWave x(p.x()), y(p.y());
  return {-x.squared_sine() * y.sine_of_twice(), x.sine_of_twice() * y.squared_sine(), 0};
}

Vec3 deformation_at(const Vec3& p) {
  const HalfWave x(p.x()), y(p.y()), z(p.z());
  return {2 * x.squared_sine() * y.sine_of_twice() * z.sine_of_twice(),
          -x.sine_of_twice() * y.squared_sine() * z.sine_of_twice(),
          -x.sine_of_twice() * y.sine_of_twice() * z.squared_sine()};
}

/// ABC flow with the coefficients of Dombre et al., for which some streamlines are chaotic.
Vec3 abc_at(const Vec3& p) {
  // The usual coefficients, for which the flow is chaotic.
  constexpr double a = std::numbers::sqrt3, b = std::numbers::sqrt2, c = 1;
  const HalfWave x(p.x()), y(p.y()), z(p.z());
  return {a * z.sine_of_twice() + c * y.cosine_of_twice(),
          b * x.sine_of_twice() + a * z.cosine_of_twice(),
          c * y.sine_of_twice() + b * x.cosine_of_twice()};
}

/// Returns the velocity field `at` multiplied by reversal(), so that particles return to their
/// starts.
AnalyticField reversing(Vec3 (*at)(const Vec3&), double period) {
  return [=](double time) -> VectorAt {
    const double factor = reversal(time, period);
    return [=](const Vec3& p) -> Vec3 { return factor * at(p); };
  };
}

AnalyticField steady(VectorAt at) {
  return [at = std::move(at)](double) { return at; };
}

}  // namespace

AnalyticField analytic_field(std::string_view name, const FlowOptions& options) {
  const Vec3 center = options.center.value_or(Vec3::Constant(0.5));
  if (name == "rotation") {
    const Vec3 axis = options.direction.value_or(Vec3::UnitZ()).stableNormalized();
    const Vec3 angular = 2 * pi / options.period.value_or(1) * axis;
    return steady([=](const Vec3& p) -> Vec3 { return angular.cross(p - center); });
  }
  if (name == "vortex") return reversing(vortex_at, options.period.value_or(8));
  if (name == "deformation") return reversing(deformation_at, options.period.value_or(3));
  if (name == "abc") return steady(abc_at);
  if (name == "shear") return steady([=](const Vec3& p) { return Vec3(p.z() - center.z(), 0, 0); });
  if (name == "expansion") return steady([=](const Vec3& p) -> Vec3 { return p - center; });
  if (name == "translation") {
    const Vec3 direction = options.direction.value_or(Vec3::UnitX()).stableNormalized();
    return steady([=](const Vec3&) { return direction; });
  }
  return {};
}

}  // namespace transformesh
