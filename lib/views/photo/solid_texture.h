/// A solid gray texture: the intensity is a function of the position in space, so that surfaces
/// need no texture coordinates (Peachey, "Solid texturing of complex surfaces", SIGGRAPH 1985). The
/// function is a sum of sine waves in random directions.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct TextureOptions {
  int waves = 40;        ///< number of waves; [1, 10000]
  double finest = 0.03;  ///< shortest wavelength, in input units; > 0
  /// Longest wavelength, in input units; >= `finest`. Logarithms of wavelengths are uniformly
  /// distributed.
  double coarsest = 0.3;
  std::uint64_t seed = 1;
};

class SolidTexture {
 public:
  /// Throws UsageError if options are out of range.
  explicit SolidTexture(const TextureOptions& options);

  /// Returns the intensity at a point: 128 on average, and rarely outside of [20, 236]. O(waves).
  float intensity_at(const Vec3& point) const;

 private:
  struct Wave {
    Vec3 frequency = Vec3::Zero();  ///< radians per unit of length
    double phase = 0;
  };
  std::vector<Wave> waves_;
  double amplitude_ = 0;
};

}  // namespace transformesh
