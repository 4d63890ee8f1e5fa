#include "views/photo/photograph.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "raster/camera.h"
#include "raster/rasterize.h"
#include "support/elementary/exponential.h"
#include "support/elementary/trigonometric.h"
#include "support/parallel.h"
#include "support/random.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

void check_photograph_options(const PhotographOptions& options) {
  if (options.samples < 1 || options.samples > 8)
    throw UsageError("a pixel needs 1 to 8 samples each way");
  if (!(options.noise >= 0 && options.offset_spread >= 0))
    throw UsageError("noise and offset must not be negative");
  if (!(options.gain_spread >= 0 && options.gain_spread < 1))
    throw UsageError("the spread of the gain must be at least 0 and less than 1");
}

/// Returns a standard normal variable, by the transform of Box and Muller.
double deviate(Random& random) {
  const double radius = std::sqrt(-2 * elementary::log(1 - random.uniform(0, 1)));
  return radius * elementary::cos(2 * std::numbers::pi * random.uniform(0, 1));
}

class Exposure {
 public:
  Exposure(const Mesh& mesh, const Camera& camera, const SolidTexture& texture,
           std::uint64_t number, const PhotographOptions& options)
      : mesh_(mesh),
        texture_(texture),
        options_(options),
        seed_(mixed(options.seed) + number),
        faces_(rasterize(mesh, camera.resampled(options.samples))) {
    Random random(seed_);
    gain_ = 1 + options.gain_spread * random.uniform(-1, 1);
    offset_ = options.offset_spread * random.uniform(-1, 1);
    photograph_ = {GrayImage(camera.width, camera.height), GrayImage(camera.width, camera.height)};
  }

  Photograph develop() {
    const auto rows = static_cast<std::size_t>(photograph_.image.height);
    parallel_for(rows, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t y = first; y < last; ++y) expose_row(static_cast<int>(y));
    });
    return std::move(photograph_);
  }

 private:
  void expose_row(int y) {
    // Each row has its own random numbers, because threads process rows in any order.
    Random random(mixed(seed_) + static_cast<std::uint64_t>(y));
    const int all = options_.samples * options_.samples;
    for (int x = 0; x < photograph_.image.width; ++x) {
      int covered = 0;
      double intensity = 0;
      for (int sample = 0; sample < all; ++sample) {
        const FacePixel& pixel = faces_.at(options_.samples * x + sample % options_.samples,
                                           options_.samples * y + sample / options_.samples);
        if (pixel.face == no_index) continue;
        ++covered;
        intensity += gain_ * texture_.intensity_at(place(pixel)) + offset_;
      }
      intensity = std::round(intensity / all + options_.noise * deviate(random));
      photograph_.image.at(x, y) = static_cast<float>(std::clamp(intensity, 0.0, 255.0));
      photograph_.silhouette.at(x, y) = 2 * covered >= all ? 255.0F : 0.0F;
    }
  }

  Vec3 place(const FacePixel& pixel) const {
    const auto [a, b, c] = mesh_.faces[pixel.face];
    const double weight_a = pixel.weight[0];
    const double weight_b = pixel.weight[1];
    return weight_a * mesh_.positions[a] + weight_b * mesh_.positions[b] +
           (1 - weight_a - weight_b) * mesh_.positions[c];
  }

  const Mesh& mesh_;
  const SolidTexture& texture_;
  const PhotographOptions& options_;
  std::uint64_t seed_;
  FaceBuffer faces_;
  double gain_ = 1;
  double offset_ = 0;
  Photograph photograph_;
};

}  // namespace

Photograph take_photograph(const Mesh& mesh, const Camera& camera, const SolidTexture& texture,
                           std::uint64_t number, const PhotographOptions& options) {
  check_photograph_options(options);
  return Exposure(mesh, camera, texture, number, options).develop();
}

}  // namespace transformesh
