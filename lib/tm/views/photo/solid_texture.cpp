#include "tm/views/photo/solid_texture.h"

#include <cmath>
#include <numbers>

#include "tm/support/error.h"
#include "tm/support/random.h"

namespace transformesh {
namespace {

constexpr double middle_level = 128;
/// Standard deviation of the levels.
constexpr double deviation = 40;

/// A direction uniform on the sphere: by Archimedes, heights are uniform.
Vec3 random_direction(Random& random) {
  const double height = random.uniform(-1, 1);
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const double radius = std::sqrt(1 - height * height);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
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
    const double octaves = random.uniform(0, std::log2(options.coarsest / options.finest));
    const double wavelength = options.finest * std::exp2(octaves);
    waves_.push_back(
        {2 * std::numbers::pi / wavelength * direction, random.uniform(0, 2 * std::numbers::pi)});
  }
  // The mean square of a sine is a half, so that the waves together have the deviation.
  amplitude_ = deviation * std::sqrt(2.0 / options.waves);
}

float SolidTexture::level_at(const Vec3& point) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += std::sin(wave.frequency.dot(point) + wave.phase);
  return static_cast<float>(middle_level + amplitude_ * sum);
}

}  // namespace transformesh
