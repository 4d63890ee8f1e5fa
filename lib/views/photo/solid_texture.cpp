#include "views/photo/solid_texture.h"

#include <array>
#include <cmath>
#include <numbers>

#include "support/elementary/double_double.h"
#include "support/elementary/exponential.h"
#include "support/elementary/trigonometric.h"
#include "support/random.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

// Mean and standard deviation of the intensities. With 128 and 40, they use most of [0, 255] but
// rarely exceed it.
constexpr double mean_intensity = 128;
constexpr double deviation = 40;  ///< standard deviation of the intensities

/// Coefficients of the Taylor series of the sine: inverse factorials of the odd numbers from 19
/// down to 1.
constexpr std::array sine_coefficients = [] {
  std::array<double, 10> coefficients{};
  double factorial = 1;
  for (int i = 0; i < 10; ++i) {
    if (i > 0) factorial *= 2.0 * i * (2 * i + 1);
    coefficients[9 - i] = 1 / factorial;
  }
  return coefficients;
}();

/// Returns a direction that is uniformly distributed on the sphere. By Archimedes' theorem, the z
/// coordinates of such directions are uniformly distributed.
Vec3 random_direction(Random& random) {
  const double height = random.uniform(-1, 1);
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const double radius = std::sqrt(1 - height * height);
  return {radius * elementary::cos(angle), radius * elementary::sin(angle), height};
}

/// Returns the sine with an error of at most 1e-13 plus one unit in the last place of `angle`. This
/// suffices for intensities of 8 bits and is faster than elementary::sin(). Reduces the angle
/// modulo pi and sums the Taylor series.
double quick_sine(double angle) {
  using elementary::inverse;
  using elementary::pi;
  const double halves = elementary::nearest_integer(angle * inverse(pi.high));
  const double x = (angle - halves * pi.high) - halves * pi.low;
  const double square = x * x;
  double series = 0;
  for (const double coefficient : sine_coefficients) series = coefficient - square * series;
  const double odd = halves - 2 * elementary::nearest_integer(halves / 2);
  return (1 - 2 * odd * odd) * x * series;
}

}  // namespace

SolidTexture::SolidTexture(const TextureOptions& options) {
  if (options.waves < 1 || options.waves > 10000)
    throw UsageError("a texture needs 1 to 10000 waves");
  if (!(options.finest > 0 && options.coarsest >= options.finest))
    throw UsageError("the wavelengths of a texture must be above 0, the finest first");
  Random random(options.seed);
  for (int i = 0; i < options.waves; ++i) {
    const Vec3 direction = random_direction(random);
    const double octaves = random.uniform(0, elementary::log2(options.coarsest / options.finest));
    const double wavelength = options.finest * elementary::exp2(octaves);
    waves_.push_back(
        {2 * std::numbers::pi / wavelength * direction, random.uniform(0, 2 * std::numbers::pi)});
  }
  // The mean square of a sine is 1/2. Hence the sum of all waves has the standard deviation
  // `deviation`.
  amplitude_ = deviation * std::sqrt(2.0 / options.waves);
}

float SolidTexture::intensity_at(const Vec3& point) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += quick_sine(wave.frequency.dot(point) + wave.phase);
  return static_cast<float>(mean_intensity + amplitude_ * sum);
}

}  // namespace transformesh
