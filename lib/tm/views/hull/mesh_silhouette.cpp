#include "tm/views/hull/mesh_silhouette.h"

namespace transformesh {

GrayImage mesh_silhouette(const Mesh& mesh, const Camera& camera) {
  const FaceBuffer faces = rasterize(mesh, camera);
  GrayImage silhouette(camera.width, camera.height);
  for (std::size_t i = 0; i < faces.pixels.size(); ++i)
    silhouette.pixels[i] = faces.pixels[i].face == no_index ? 0.0F : 255.0F;
  return silhouette;
}

}  // namespace transformesh
