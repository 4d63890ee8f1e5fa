#include "reconstruction/outline_agreements.h"

#include "views/hull/silhouette.h"

namespace transformesh {

std::vector<double> outline_agreements(const Mesh& mesh, const PhotoScene& scene) {
  std::vector<double> agreements;
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    if (scene.distances[v].empty()) continue;
    GrayImage silhouette = scene.distances[v];
    for (float& intensity : silhouette.pixels) intensity = intensity < 0 ? 255.0F : 0.0F;
    agreements.push_back(silhouette_agreement(mesh_silhouette(mesh, scene.views[v]), silhouette));
  }
  return agreements;
}

}  // namespace transformesh
