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

Camera camera_of(const View& view) {
  return {view.camera.projection(), view.image.width, view.image.height};
}

GrayImage depths_of(const Mesh& mesh, const View& view) {
  constexpr int rows_per_band = 16;
  const Camera camera = camera_of(view);
  const BandRasterizer bands(mesh, camera, rows_per_band, Sides::outside);
  GrayImage depths(camera.width, camera.height);
  std::vector<FacePixel> rows;
  for (std::size_t band = 0; band < bands.bands(); ++band) {
    rows.assign(static_cast<std::size_t>(rows_per_band) * static_cast<std::size_t>(camera.width),
                {});
    bands.draw(band, rows.data());
    const int start = static_cast<int>(band) * rows_per_band;
    const int count = std::min(rows_per_band, camera.height - start) * camera.width;
    std::transform(rows.begin(), rows.begin() + count, depths.row(start),
                   [](const FacePixel& pixel) { return pixel.depth; });
  }
  return depths;
}

GrayImage depths_of(const FaceBuffer& faces) {
  GrayImage depths(faces.width, faces.height);
  std::transform(faces.pixels.begin(), faces.pixels.end(), depths.pixels.begin(),
                 [](const FacePixel& pixel) { return pixel.depth; });
  return depths;
}

std::vector<Vec3f> face_unit_normals(const Mesh& mesh) {
  std::vector<Vec3f> normals(mesh.faces.size());
  for (std::size_t f = 0; f < normals.size(); ++f)
    normals[f] = face_normal(mesh, static_cast<Index>(f)).normalized().cast<float>();
  return normals;
}

}  // namespace

SeenViews::SeenViews(const Mesh& mesh, std::span<const View> views, double least_cosine)
    : mesh_(mesh),
      views_(views),
      least_cosine_(least_cosine),
      normals_(face_unit_normals(mesh)),
      depths_(views.size()),
      surfaces_(views.size()) {
  parallel_for(views.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      if (views[v].image.is_packed()) {
        depths_[v] = depths_of(mesh, views[v]);
        depths_[v].pack(HeldImage::Kind::depths);
      } else {
        surfaces_[v] = see(v);
        depths_[v] = depths_of(surfaces_[v].faces);
      }
    }
  });
}

const SeenSurface& SeenViews::surface(std::size_t view, SeenSurface& room) const {
  if (!views_[view].image.is_packed()) return surfaces_[view];
  room = see(view);
  return room;
}

SeenSurface SeenViews::see(std::size_t view) const {
  const Camera camera = camera_of(views_[view]);
  SeenSurface seen;
  seen.faces = rasterize(mesh_, camera, Sides::outside);
  seen.depth = seen.inverse_facing = GrayImage(camera.width, camera.height);
  seen.first_column = camera.width;
  seen.first_row = camera.height;
  for (int y = 0; y < camera.height; ++y)
    compare_row(seen, normals_, views_[view].camera, static_cast<float>(least_cosine_), y);
  return seen;
}

}  // namespace transformesh
