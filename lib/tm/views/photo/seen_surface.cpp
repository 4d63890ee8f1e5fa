#include "tm/views/photo/seen_surface.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "tm/mesh/measure.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

using Vec3f = Eigen::Vector3f;

/// 1 / (r N) where the face is seen from outside and steeply enough, else 0.
float inverse_facing(const Vec3f& ray, const Vec3f& normal, float least_cosine) {
  const float facing = ray.dot(normal);
  const bool is_seen =
      facing < 0 && facing * facing > least_cosine * least_cosine * ray.squaredNorm();
  return is_seen ? 1 / facing : 0;
}

void grow_box(SeenSurface& seen, int x, int y) {
  seen.first_column = std::min(seen.first_column, x);
  seen.end_column = std::max(seen.end_column, x + 1);
  seen.first_row = std::min(seen.first_row, y);
  seen.end_row = std::max(seen.end_row, y + 1);
}

void compare_row(SeenSurface& seen, std::span<const Vec3f> normals, const PinholeCamera& camera,
                 float least_cosine, int y) {
  const Vec3f start = camera.ray(0, y).cast<float>();
  const Vec3f step = (camera.ray(1, y) - camera.ray(0, y)).cast<float>();
  for (int x = 0; x < seen.faces.width; ++x) {
    const FacePixel& pixel = seen.faces.at(x, y);
    if (pixel.face == no_index) continue;
    const Vec3f ray = start + static_cast<float>(x) * step;
    const float inverse = inverse_facing(ray, normals[pixel.face], least_cosine);
    if (inverse == 0) continue;
    seen.inverse_facing.at(x, y) = inverse;
    seen.depth.at(x, y) = pixel.depth;
    grow_box(seen, x, y);
  }
}

/// Pixels without a face have depth 0, and so extend no reach.
void find_reach(SeenSurface& seen) {
  const FaceBuffer& faces = seen.faces;
  for (int y = 0; y + 1 < faces.height; ++y) {
    for (int x = 0; x + 1 < faces.width; ++x) {
      seen.reach.at(x, y) = std::max({faces.at(x, y).depth, faces.at(x + 1, y).depth,
                                      faces.at(x, y + 1).depth, faces.at(x + 1, y + 1).depth});
    }
  }
}

SeenSurface see(const Mesh& mesh, std::span<const Vec3f> normals, const View& view,
                double least_cosine) {
  const int width = view.image.width;
  const int height = view.image.height;
  SeenSurface seen;
  seen.faces = rasterize(mesh, {view.camera.projection(), width, height}, Sides::outside);
  seen.depth = seen.inverse_facing = seen.reach = GrayImage(width, height);
  seen.first_column = width;
  seen.first_row = height;
  for (int y = 0; y < height; ++y)
    compare_row(seen, normals, view.camera, static_cast<float>(least_cosine), y);
  find_reach(seen);
  return seen;
}

}  // namespace

std::vector<Vec3f> face_unit_normals(const Mesh& mesh) {
  std::vector<Vec3f> normals(mesh.faces.size());
  for (std::size_t f = 0; f < normals.size(); ++f)
    normals[f] = face_normal(mesh, static_cast<Index>(f)).normalized().cast<float>();
  return normals;
}

std::vector<SeenSurface> see_surface(const Mesh& mesh, std::span<const Vec3f> normals,
                                     std::span<const View> views, double least_cosine) {
  std::vector<SeenSurface> seen(views.size());
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) seen[v] = see(mesh, normals, views[v], least_cosine);
  });
  return seen;
}

}  // namespace transformesh
