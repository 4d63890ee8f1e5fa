// Moves a sphere that is too large towards eight synthetic photographs of a unit sphere.
#include <transformesh/photo_step.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

static double mean_radius(const Mesh& mesh) {
  double sum = 0;
  for (const Vec3& p : mesh.positions) sum += p.norm();
  return sum / static_cast<double>(mesh.positions.size());
}

int main() {
  Views views;
  for (int view = 0; view < 8; ++view) {  // Cameras on a circle, at distance 5.
    const double c = std::cos(view * std::acos(0.0) / 2), s = std::sin(view * std::acos(0.0) / 2);
    PinholeCamera camera;
    camera.intrinsics << 160, 0, 47.5, 0, 160, 47.5, 0, 0, 1;
    camera.rotation << -s, c, 0, 0, 0, -1, -c, -s, 0;
    camera.translation = Vec3(0, 0, 5);
    GrayImage photograph(96, 96), silhouette(96, 96);
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 96; ++x) {
        const Vec3 ray = camera.ray(x, y).normalized(), eye = camera.center();
        const double along = eye.dot(ray), root = along * along - eye.squaredNorm() + 1;
        if (root < 0) continue;
        const Vec3 p = eye - (along + std::sqrt(root)) * ray;
        silhouette.at(x, y) = 255;
        photograph.at(x, y) = static_cast<float>(128 + 60 * std::sin(9 * p.x() + 5 * p.z()) +
                                                 60 * std::sin(11 * p.y() - 7 * p.z()));
      }
    views.add("view" + std::to_string(view), camera, photograph, silhouette);
  }
  Mesh mesh = make_sphere(Vec3::Zero(), 1.05, 1000);
  const double before = mean_radius(mesh);
  const PhotoStepResult result = photo_step(mesh, views, 1);
  if (result.pixels == 0 || result.displaced.moved == 0 || result.outside == 0) return 1;
  return std::abs(mean_radius(mesh) - 1) < 0.8 * std::abs(before - 1) ? 0 : 1;
}
