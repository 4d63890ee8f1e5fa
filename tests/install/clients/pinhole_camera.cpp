// Checks center, rays, projection and pixel size of a camera at (0, 0, -5) that looks along z.
#include <transformesh/pinhole_camera.h>

#include <array>
#include <cmath>

using namespace transformesh;

int main() {
  PinholeCamera camera;
  camera.intrinsics << 100, 0, 32, 0, 100, 24, 0, 0, 1;
  camera.translation = Vec3(0, 0, 5);
  if ((camera.center() - Vec3(0, 0, -5)).norm() > 1e-12 || camera.focal_length() != 100) return 1;
  const Vec3 point(0.3, -0.2, 1);
  const Vec3 q = camera.projection() * Eigen::Vector4d(0.3, -0.2, 1, 1);
  if (std::abs(q.z() - 6) > 1e-12) return 1;
  const Vec3 again = camera.center() + q.z() * camera.ray(q.x() / q.z(), q.y() / q.z());
  if ((again - point).norm() > 1e-12) return 1;
  if (std::abs(pixel_size(std::span(&camera, 1), point) - 0.06) > 1e-12) return 1;
  if (std::abs(camera.shrunk(2).focal_length() - 50) > 1e-12) return 1;
  const std::array<PinholeCamera, 1> mirror{camera.mirrored()};
  if (viewed_point(mirror).head<2>().norm() > 1e-12) return 1;
  try {
    pixel_size(std::span(&camera, 1), Vec3(0, 0, -6));
  } catch (const InputError&) {
    return 0;
  }
  return 1;
}
