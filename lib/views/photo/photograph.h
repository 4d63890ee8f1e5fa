/// Simulates photographs of a textured surface, for tests of reconstruction with known results.
#pragma once

#include <cstdint>

#include "raster/camera.h"
#include "transformesh/image.h"
#include "views/photo/solid_texture.h"

namespace transformesh {

struct PhotographOptions {
  int samples = 3;   ///< number of samples per pixel along each axis, which are averaged; [1, 8]
  double noise = 2;  ///< standard deviation of the sensor noise, in intensities; >= 0
  /// Intensities of a photograph are multiplied by a random factor between 1 - `gain_spread` and
  /// 1 + `gain_spread`; [0, 1).
  double gain_spread = 0;
  /// A random number of at most this magnitude is added to all intensities of a photograph; >= 0.
  double offset_spread = 0;
  std::uint64_t seed = 1;  ///< seed of noise, gain and offset
};

struct Photograph {
  GrayImage image;  ///< integer intensities from 0 to 255; the background is black except for noise
  GrayImage silhouette;  ///< 255 if at least half of the pixel shows the surface, else 0
};

/// Renders the surface with the texture but without shading, as a matte surface in diffuse light.
/// `number` is the index of the photograph, so that each has different noise. Throws UsageError if
/// options are out of range. O(faces + covered pixels * samples^2 * waves of the texture),
/// parallel; the result does not depend on the number of threads.
Photograph take_photograph(const Mesh& mesh, const Camera& camera, const SolidTexture& texture,
                           std::uint64_t number, const PhotographOptions& options = {});

}  // namespace transformesh
