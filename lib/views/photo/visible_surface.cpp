#include "views/photo/visible_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>

#include "raster/camera.h"
#include "support/parallel.h"
#include "transformesh/measure.h"
#include "views/cameras/view.h"

namespace transformesh {
namespace {

using Vec3f = Eigen::Vector3f;

constexpr int rows_per_band = 16;  ///< rows of pixels per parallel task; affects time only

/// Returns 1 / dot(ray, normal) if the camera observes the front of the face and the cosine between
/// ray and normal is above `least_cosine`; else 0.
float inverse_facing(const Vec3f& ray, const Vec3f& normal, float least_cosine) {
  const float facing = ray.dot(normal);
  const bool is_seen =
      facing < 0 && facing * facing > least_cosine * least_cosine * ray.squaredNorm();
  return is_seen ? 1 / facing : 0;
}

/// Extends the box so that it contains pixel (x, y). For an empty box, the caller must have set the
/// first column and row to large values, and the ends to small ones.
void grow(PixelBox& box, int x, int y) {
  box.first_column = std::min(box.first_column, x);
  box.end_column = std::max(box.end_column, x + 1);
  box.first_row = std::min(box.first_row, y);
  box.end_row = std::max(box.end_row, y + 1);
}

/// Computes `depth` and `inverse_facing` in row `y` of the view.
void compare_row(VisibleSurface& seen, std::span<const Vec3f> normals, const PinholeCamera& camera,
                 float least_cosine, int y) {
  const Vec3f start = camera.ray(0, y).cast<float>();
  const Vec3f step = (camera.ray(1, y) - camera.ray(0, y)).cast<float>();
  const int row = y - seen.box.first_row;
  for (int i = 0; i < seen.faces.width; ++i) {
    const FacePixel& pixel = seen.faces.at(i, row);
    const int x = seen.box.first_column + i;
    const Vec3f ray = start + static_cast<float>(x) * step;
    const float inverse =
        pixel.face == no_index ? 0 : inverse_facing(ray, normals[pixel.face], least_cosine);
    seen.inverse_facing.at(i, row) = inverse;
    seen.depth.at(i, row) = inverse == 0 ? 0 : pixel.depth;
    if (inverse != 0) grow(seen.compared, x, y);
  }
}

Camera camera_of(const View& view) {
  return {view.camera.projection(), view.image.width, view.image.height};
}

/// Rasterizes the mesh in parallel, in bands of rows. Calls `take` for each row inside the box of
/// `bands`. `row` points to the pixel in the first column of the box.
void draw_rows(const BandRasterizer& bands, int width,
               const std::function<void(int y, const FacePixel* row)>& take) {
  const PixelBox& box = bands.box();
  parallel_for(bands.bands(), 1, [&](std::size_t first, std::size_t last) {
    std::vector<FacePixel> rows;
    for (std::size_t band = first; band < last; ++band) {
      const int start = static_cast<int>(band) * rows_per_band;
      if (start >= box.end_row || start + rows_per_band <= box.first_row) continue;
      rows.assign(static_cast<std::size_t>(rows_per_band) * static_cast<std::size_t>(width), {});
      bands.draw(band, rows.data());
      for (int y = std::max(start, box.first_row); y < std::min(start + rows_per_band, box.end_row);
           ++y)
        take(y, rows.data() + static_cast<std::ptrdiff_t>(y - start) * width + box.first_column);
    }
  });
}

GrayImage framed(const PixelBox& box) { return {box.columns() + 2, box.rows() + 2}; }

void keep_depths(const FacePixel* row, int count, float* depths) {
  std::transform(row, row + count, depths, [](const FacePixel& pixel) { return pixel.depth; });
}

VisibleDepths packed_depths(const Mesh& mesh, const View& view) {
  const Camera camera = camera_of(view);
  const BandRasterizer bands(mesh, camera, rows_per_band, Sides::outside);
  const PixelBox& box = bands.box();
  GrayImage depths = framed(box);
  draw_rows(bands, camera.width, [&](int y, const FacePixel* row) {
    keep_depths(row, box.columns(), depths.row(y - box.first_row + 1) + 1);
  });
  PackableImage held = std::move(depths);
  held.pack(PackableImage::Kind::depths);
  return {std::move(held), box};
}

VisibleDepths depths_of(const VisibleSurface& seen) {
  GrayImage depths = framed(seen.box);
  for (int y = 0; y < seen.faces.height; ++y)
    keep_depths(seen.faces.row(y), seen.faces.width, depths.row(y + 1) + 1);
  return {std::move(depths), seen.box};
}

/// Resizes the raster to the size of the box. If it was empty, all pixels have default values;
/// otherwise pixels have arbitrary values.
template <class Value>
void resize(Raster<Value>& raster, const PixelBox& box) {
  raster.width = box.columns();
  raster.height = box.rows();
  raster.pixels.resize(static_cast<std::size_t>(box.columns()) *
                       static_cast<std::size_t>(box.rows()));
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
        depths_[v] = packed_depths(mesh, views[v]);
      } else {
        see(v, surfaces_[v]);
        depths_[v] = depths_of(surfaces_[v]);
      }
    }
  });
}

const VisibleSurface& SeenViews::surface(std::size_t view, VisibleSurface& room) const {
  if (!views_[view].image.is_packed()) return surfaces_[view];
  see(view, room);
  return room;
}

void SeenViews::see(std::size_t view, VisibleSurface& seen) const {
  const Camera camera = camera_of(views_[view]);
  // Views with packed images are large, and few of them are processed at the same time. Their bands
  // are therefore drawn in parallel.
  const int rows = views_[view].image.is_packed() ? rows_per_band : std::max(camera.height, 1);
  const BandRasterizer bands(mesh_, camera, rows, Sides::outside);
  const PixelBox& box = seen.box = bands.box();
  seen.faces.pixels.clear();
  resize(seen.faces, box);
  resize(seen.depth, box);
  resize(seen.inverse_facing, box);
  parallel_for(bands.bands(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t band = first; band < last; ++band)
      bands.draw(band, box, seen.faces.pixels.data());
  });
  const PackableImage& image = views_[view].image;
  if (image.is_packed())
    image.unpack_rectangle(box.first_column, box.first_row, box.columns(), box.rows(),
                           seen.intensity);
  seen.compared = {camera.width, 0, camera.height, 0};
  for (int y = box.first_row; y < box.end_row; ++y)
    compare_row(seen, normals_, views_[view].camera, static_cast<float>(least_cosine_), y);
}

}  // namespace transformesh
