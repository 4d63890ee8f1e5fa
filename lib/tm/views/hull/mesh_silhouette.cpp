#include "tm/views/hull/mesh_silhouette.h"

#include "tm/views/hull/silhouette.h"

namespace transformesh {

GrayImage mesh_silhouette(const Mesh& mesh, const Camera& camera) {
  const FaceBuffer faces = rasterize(mesh, camera);
  GrayImage silhouette(camera.width, camera.height);
  for (std::size_t i = 0; i < faces.pixels.size(); ++i)
    silhouette.pixels[i] = faces.pixels[i].face == no_index ? 0.0F : 255.0F;
  return silhouette;
}

GrayImage mesh_silhouette(const Mesh& mesh, const View& view) {
  const GrayImage& image = view.image.empty() ? view.silhouette : view.image;
  return mesh_silhouette(mesh, {view.camera.projection(), image.width, image.height});
}

std::vector<double> silhouette_agreements(const Mesh& mesh, std::span<const View> views) {
  std::vector<double> agreements;
  for (const View& view : views)
    agreements.push_back(silhouette_agreement(mesh_silhouette(mesh, view), view.silhouette));
  return agreements;
}

}  // namespace transformesh
