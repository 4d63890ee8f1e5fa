/// A gray texture that fills space, so that surfaces cut from it need no coordinates of their own:
/// the sum of waves in random directions (Peachey, "Solid texturing of complex surfaces", SIGGRAPH
/// 1985).
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

struct TextureOptions {
  int waves = 40;         ///< [1, 10000]
  double finest = 0.03;   ///< > 0: shortest wavelength, in input units
  double coarsest = 0.3;  ///< >= finest: longest; wavelengths between are drawn by octave
  std::uint64_t seed = 1;
};

class SolidTexture {
 public:
  /// Throws UsageError for options out of range.
  explicit SolidTexture(const TextureOptions& options);

  /// Gray intensities around 128 that rarely leave 20 to 236. O(waves).
  float intensity_at(const Vec3& point) const;

 private:
  struct Wave {
    Vec3 frequency = Vec3::Zero();  ///< radians a unit of length
    double phase = 0;
  };
  std::vector<Wave> waves_;
  double amplitude_ = 0;
};

}  // namespace transformesh
