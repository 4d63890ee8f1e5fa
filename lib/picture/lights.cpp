#include "picture/lights.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "raster/camera.h"

namespace transformesh {
namespace {

// Linear colors of the ambient light from above and below.
const Color sky(0.26F, 0.29F, 0.34F);
const Color ground(0.10F, 0.09F, 0.08F);
constexpr float gloss = 0.14F;  ///< weight of specular reflections

float sharpened(float x) {
  for (int i = 0; i < 5; ++i) x *= x;
  return x;
}

}  // namespace

Lights::Lights(const Camera& camera, const Vec3& upright) : upright_(upright.cast<float>()) {
  const Vec3 forward = camera.projection.row(2).head<3>().normalized();
  const Vec3 down = camera.projection.row(1).head<3>();
  const Vec3 up = -(down - down.dot(forward) * forward).normalized();
  const Vec3 right = forward.cross(up);
  const auto towards = [&](double x, double y, double z) -> Eigen::Vector3f {
    return (x * right + y * up - z * forward).normalized().cast<float>();
  };
  lights_ = {Light{towards(-0.70, 0.75, 0.55), Color(1.00F, 0.95F, 0.86F)},
             Light{towards(0.85, 0.05, 0.45), Color(0.14F, 0.17F, 0.24F)},
             Light{towards(0.35, 0.60, -0.75), Color(0.40F, 0.41F, 0.43F)}};
}

Color Lights::reflected(const Color& surface, const Eigen::Vector3f& normal,
                        const Eigen::Vector3f& to_eye, float key_share) const {
  const float height = 0.5F + 0.5F * normal.dot(upright_);
  Color diffuse = ground + height * (sky - ground);
  Color glossy = Color::Zero();
  for (const Light& light : lights_) {
    const float facing = normal.dot(light.direction);
    if (facing <= 0) continue;
    const Color color = (&light == lights_.data() ? key_share : 1.0F) * light.color;
    diffuse += facing * color;
    const Eigen::Vector3f halfway = (light.direction + to_eye).normalized();
    glossy += sharpened(std::max(0.0F, normal.dot(halfway))) * color;
  }
  return surface.cwiseProduct(diffuse) + gloss * glossy;
}

}  // namespace transformesh
