// Computes the hull of six silhouettes of a unit sphere, which contains the sphere closely.
#include <transformesh/hull.h>

#include <cmath>

using namespace transformesh;

int main() {
  Views views;
  for (int view = 0; view < 6; ++view) {  // Two cameras on each axis, at distance 5.
    const double sign = view % 2 ? 1 : -1;
    PinholeCamera camera;
    camera.intrinsics << 200, 0, 63.5, 0, 200, 63.5, 0, 0, 1;
    camera.rotation.setZero();
    for (int i = 0; i < 3; ++i) camera.rotation(i, (view / 2 + 1 + i) % 3) = i ? sign : 1;
    camera.translation = Vec3(0, 0, 5);
    GrayImage silhouette(128, 128);
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) {  // The ray meets the sphere if its distance from 0 is <= 1.
        const Vec3 ray = camera.ray(x, y).normalized(), eye = camera.center();
        const double along = eye.dot(ray);
        silhouette.at(x, y) = eye.squaredNorm() - along * along <= 1 ? 255 : 0;
      }
    views.add("view" + std::to_string(view), camera, {}, silhouette);
  }
  const HullResult result = visual_hull(views, {.resolution = 32});
  const double ball = 4 * std::acos(-1.0) / 3, hull = volume(result.mesh);
  if (hull < ball || hull > 1.5 * ball || result.cell <= 0) return 1;
  try {
    visual_hull(Views());
  } catch (const InputError&) {
    return 0;
  }
  return 1;
}
