/// A photographer's lights, which move with the eye: a key from the upper left, a fill from the
/// right, a rim from behind, and sky and ground all around.
#pragma once

#include "picture/linear_color.h"
#include "raster/camera.h"

namespace transformesh {

class Lights {
 public:
  /// For an eye at the camera's center; `upright` is the direction of the sky, of length 1.
  Lights(const Camera& camera, const Vec3& upright);

  /// The light that leaves a surface of that color towards the eye. The normal and the direction
  /// to the eye have length 1; of the key light that share arrives.
  Color reflected(const Color& surface, const Eigen::Vector3f& normal,
                  const Eigen::Vector3f& to_eye, float key_share = 1) const;
  /// Of length 1.
  Vec3 towards_key() const { return lights_[0].direction.cast<double>().normalized(); }

 private:
  struct Light {
    Eigen::Vector3f direction;  ///< towards it
    Color color;
  };
  std::array<Light, 3> lights_;
  Eigen::Vector3f upright_;
};

}  // namespace transformesh
