// Reconstructs a unit sphere from twelve synthetic photographs with silhouettes.
#include <transformesh/reconstruct.h>

#include <cmath>

using namespace transformesh;

int main() {
  Views views;
  for (int view = 0; view < 12; ++view) {  // Cameras on a circle, at distance 5.
    const double c = std::cos(view * std::acos(-1.0) / 6), s = std::sin(view * std::acos(-1.0) / 6);
    PinholeCamera camera;
    camera.intrinsics << 80, 0, 23.5, 0, 80, 23.5, 0, 0, 1;
    camera.rotation << -s, c, 0, 0, 0, -1, -c, -s, 0;
    camera.translation = Vec3(0, 0, 5);
    GrayImage photograph(48, 48), silhouette(48, 48);
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
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
  Document document;
  ReconstructionOptions options;
  options.scales.coarsest = 1;
  options.sweeps = 1;
  const ReconstructionResult result = reconstruct(document, views, options);
  if (result.sweeps == 0 || result.topology != Topology{1, 0}) return 1;
  if (result.faces != document.mesh.faces.size() || result.agreement < 0.8) return 1;
  return std::abs(volume(document.mesh) - 4 * std::acos(-1.0) / 3) < 0.6 ? 0 : 1;
}
