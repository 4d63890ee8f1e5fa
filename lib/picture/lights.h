/// Studio lighting that moves with the camera. There are a key light from the upper left, a fill
/// light from the right and a rim light from behind. Ambient light comes from sky and ground.
#pragma once

#include "picture/linear_color.h"
#include "raster/camera.h"

namespace transformesh {

class Lights {
 public:
  /// `upright` is the unit vector towards the sky.
  Lights(const Camera& camera, const Vec3& upright);

  /// Returns the light that a surface of this color reflects to the camera. `normal` and `to_eye`
  /// are unit vectors. `key_share` is the fraction of the key light that reaches the surface.
  Color reflected(const Color& surface, const Eigen::Vector3f& normal,
                  const Eigen::Vector3f& to_eye, float key_share = 1) const;
  /// Returns the unit vector towards the key light.
  Vec3 towards_key() const { return lights_[0].direction.cast<double>().normalized(); }

 private:
  struct Light {
    Eigen::Vector3f direction;  ///< towards the light
    Color color;
  };
  std::array<Light, 3> lights_;
  Eigen::Vector3f upright_;
};

}  // namespace transformesh
