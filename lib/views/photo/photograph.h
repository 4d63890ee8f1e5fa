/// Photographs that a camera would take of a textured surface: known truth for tests of
/// reconstruction.
#pragma once

#include <cstdint>

#include "raster/camera.h"
#include "transformesh/image.h"
#include "views/photo/solid_texture.h"

namespace transformesh {

struct PhotographOptions {
  int samples = 3;   ///< [1, 8] each way in a pixel: pixels are averages, as in a camera
  double noise = 2;  ///< >= 0: deviation of the sensor's noise, in intensities
  double gain_spread =
      0;  ///< [0, 1): intensities of a photograph are scaled by 1, give or take this
  double offset_spread = 0;  ///< >= 0: and shifted by at most so many intensities
  std::uint64_t seed = 1;    ///< of noise, gain and offset
};

struct Photograph {
  GrayImage image;       ///< whole intensities from 0 to 255; the background is black but for noise
  GrayImage silhouette;  ///< 255 where at least half of the pixel shows the surface, else 0
};

/// The surface shows the texture without shading, as a matte one does in diffuse light. `number` is
/// that of the photograph: each has its own noise. Throws UsageError for options out of range.
/// O(faces + pixels covered * samples^2 * waves), parallel; the same bytes for any number of
/// threads.
Photograph take_photograph(const Mesh& mesh, const Camera& camera, const SolidTexture& texture,
                           std::uint64_t number, const PhotographOptions& options = {});

}  // namespace transformesh
