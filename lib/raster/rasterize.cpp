#include "raster/rasterize.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "raster/camera.h"
#include "support/parallel.h"

namespace transformesh {

namespace {

// Inlined, because a function call for each face took as long as the computation.
[[gnu::always_inline]] inline EdgeFunctions functions_of(const Vec3& a, const Vec3& b,
                                                         const Vec3& c) {
  EdgeFunctions functions;
  const Vec3 across_a = b.cross(c);
  const double determinant = a.dot(across_a);
  if (!(std::abs(determinant) > 0)) return functions;
  const double sign = determinant > 0 ? 1 : -1;
  functions.edge = {sign * across_a, sign * c.cross(a), sign * a.cross(b)};
  functions.depth_numerator = std::abs(determinant);
  return functions;
}

constexpr int usual_rows_per_band = 16;  ///< affects time only
/// If a face has fewer columns than this, calling narrowed() takes more time than it saves.
constexpr int columns_worth_narrowing = 8;
constexpr std::size_t items_per_task = 4096;  ///< affects time only
/// Number of faces whose bounds are stored at the same time while sorting, to limit memory.
constexpr std::size_t faces_at_once = std::size_t{1} << 16;

/// A range of pixels; `last` is included.
struct Range {
  int first = 0;
  int last = -1;
};

/// Bounding box of the pixels that a face may cover.
struct Bounds {
  Range columns;
  Range rows;

  bool is_empty() const { return columns.first > columns.last || rows.first > rows.last; }
};

/// Values that are computed once for a face, before its pixels are drawn.
struct FaceSetup {
  EdgeFunctions functions;
  Bounds bounds;
};

using Corners = std::array<Vec3, 3>;
using PixelPlace = Eigen::Array2d;

/// Returns the integers in [low, high] that are in [0, size - 1]: the pixels of a row or column of
/// `size` pixels.
Range pixels_between(double low, double high, int size) {
  if (!(low <= high)) return {};
  low = std::max(low, 0.0);
  high = std::min(high, size - 1.0);
  if (!(low <= high)) return {};
  // `low` and `high` are not negative, so that the conversion to int rounds down. std::ceil and
  // std::floor would be slower: without SSE 4.1 they are calls of the C library.
  const int below = static_cast<int>(low);
  return {below < low ? below + 1 : below, static_cast<int>(high)};
}

/// Returns a bounding box of the pixels of a face. Returns the whole image if the face reaches
/// behind the camera. `pixels` contains the projection of each vertex of the mesh.
Bounds bounds_of(const Face& face, const Corners& corners, const std::vector<PixelPlace>& pixels,
                 int width, int height) {
  if (!(corners[0].z() > 0 && corners[1].z() > 0 && corners[2].z() > 0))
    return {{0, width - 1}, {0, height - 1}};
  const PixelPlace& a = pixels[face[0]];
  const PixelPlace& b = pixels[face[1]];
  const PixelPlace& c = pixels[face[2]];
  const PixelPlace low = a.min(b).min(c);
  const PixelPlace high = a.max(b).max(c);
  return {pixels_between(low.x(), high.x(), width), pixels_between(low.y(), high.y(), height)};
}

void unite(Range& range, const Range& other) {
  if (range.first > range.last) range = other;
  range.first = std::min(range.first, other.first);
  range.last = std::max(range.last, other.last);
}

/// Returns the columns of a row in which all edge functions can be positive, and one more column on
/// both sides. Edge function i is `start[i] + slope[i] * x` in column x.
Range narrowed(Range columns, const std::array<double, 3>& slope,
               const std::array<double, 3>& start) {
  double low = columns.first;
  double high = columns.last;
  for (std::size_t i = 0; i < 3; ++i) {
    const double root = -start[i] / slope[i];
    if (slope[i] > 0) low = std::max(low, root - 1);
    if (slope[i] < 0) high = std::min(high, root + 1);
  }
  if (!(low <= high)) return {};
  return {static_cast<int>(std::ceil(low)), static_cast<int>(std::floor(high))};
}

/// Draws the pixels of a face in row `y` of the image. `row` points to the pixel of that row in
/// column `left`.
void draw_row(const FaceSetup& setup, Index face, int y, FacePixel* row, int left) {
  std::array<double, 3> slope;
  std::array<double, 3> start;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& edge = setup.functions.edge[i];
    slope[i] = edge.x();
    start[i] = edge.y() * y + edge.z();
  }
  const Range& all = setup.bounds.columns;
  const bool is_narrow = all.last - all.first < columns_worth_narrowing;
  const Range columns = is_narrow ? all : narrowed(all, slope, start);
  for (int x = columns.first; x <= columns.last; ++x) {
    const double e0 = slope[0] * x + start[0];
    const double e1 = slope[1] * x + start[1];
    const double e2 = slope[2] * x + start[2];
    // A single condition without short-circuit: half of the tested pixels of a small face are
    // outside, so that branches would be mispredicted.
    if (!((e0 >= 0) & (e1 >= 0) & (e2 >= 0))) continue;
    const double sum = e0 + e1 + e2;
    if (!(sum > 0)) continue;
    const auto depth = static_cast<float>(setup.functions.depth_numerator / sum);
    FacePixel& pixel = row[x - left];
    if (pixel.face != no_index && !(depth < pixel.depth)) continue;
    pixel = {face, depth, {static_cast<float>(e0 / sum), static_cast<float>(e1 / sum)}};
  }
}

}  // namespace

EdgeFunctions edge_functions(const Vec3& a, const Vec3& b, const Vec3& c) {
  return functions_of(a, b, c);
}

bool BandRasterizer::Drawn::operator()(const Corners& corners) const {
  if (corners[0].z() <= 0 && corners[1].z() <= 0 && corners[2].z() <= 0) return false;
  return is_both || sign * corners[0].dot(corners[1].cross(corners[2])) > 0;
}

BandRasterizer::BandRasterizer(const Mesh& mesh, const Camera& camera, int rows_per_band,
                               Sides sides)
    : mesh_(mesh),
      width_(camera.width),
      height_(camera.height),
      rows_per_band_(rows_per_band),
      is_drawn_{sides == Sides::both,
                camera.projection.leftCols<3>().determinant() > 0 ? -1.0 : 1.0},
      projected_(mesh.positions.size()),
      pixels_(mesh.positions.size()),
      faces_(static_cast<std::size_t>((height_ + rows_per_band_ - 1) / rows_per_band_)) {
  parallel_for(projected_.size(), items_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      projected_[v] = camera.project(mesh.positions[v]);
      pixels_[v] = projected_[v].head<2>().array() / projected_[v].z();
    }
  });
  if (is_whole())
    bound_vertices();
  else
    sort_faces();
}

Corners BandRasterizer::corners_of(const Face& face) const {
  return {projected_[face[0]], projected_[face[1]], projected_[face[2]]};
}

// Sorts faces into the bands of rows that they touch, in face order. FaceSetup is computed only
// when a face is drawn, because storing it for all faces would take several times the memory of the
// mesh.
void BandRasterizer::sort_faces() {
  Bounds all;
  std::vector<Bounds> some;
  for (std::size_t start = 0; start < mesh_.faces.size(); start += faces_at_once) {
    some.assign(std::min(faces_at_once, mesh_.faces.size() - start), {});
    parallel_for(some.size(), items_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Face& face = mesh_.faces[start + i];
        const Corners corners = corners_of(face);
        if (is_drawn_(corners)) some[i] = bounds_of(face, corners, pixels_, width_, height_);
      }
    });
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (some[i].is_empty()) continue;
      const Range& rows = some[i].rows;
      unite(all.columns, some[i].columns);
      unite(all.rows, rows);
      for (int band = rows.first / rows_per_band_; band <= rows.last / rows_per_band_; ++band)
        faces_[static_cast<std::size_t>(band)].push_back(static_cast<Index>(start + i));
    }
  }
  box_ = {all.columns.first, all.columns.last + 1, all.rows.first, all.rows.last + 1};
}

// Sets `box_` to the bounding box of all projected vertices, which contains all visible faces.
void BandRasterizer::bound_vertices() {
  PixelPlace low(HUGE_VAL, HUGE_VAL);
  PixelPlace high = -low;
  bool is_in_front = true;
  for (std::size_t v = 0; v < pixels_.size(); ++v) {
    low = low.min(pixels_[v]);
    high = high.max(pixels_[v]);
    is_in_front = is_in_front && projected_[v].z() > 0;
  }
  box_ = {0, width_, 0, height_};
  if (!is_in_front) return;
  const Range columns = pixels_between(low.x(), high.x(), width_);
  const Range rows = pixels_between(low.y(), high.y(), height_);
  const bool is_empty = Bounds{columns, rows}.is_empty();
  box_ =
      is_empty ? PixelBox() : PixelBox{columns.first, columns.last + 1, rows.first, rows.last + 1};
}

void BandRasterizer::draw(std::size_t band, FacePixel* rows) const {
  const int first = static_cast<int>(band) * rows_per_band_;
  draw(band, {0, width_, first, first + rows_per_band_}, rows);
}

void BandRasterizer::draw(std::size_t band, const PixelBox& part, FacePixel* pixels) const {
  const int start = static_cast<int>(band) * rows_per_band_;
  const int first = std::max(start, part.first_row);
  const int last = std::min(start + rows_per_band_, part.end_row) - 1;
  if (is_whole()) {
    for (Index face = 0; face < mesh_.faces.size(); ++face)
      draw_face(face, first, last, part, pixels);
  } else {
    for (const Index face : faces_[band]) draw_face(face, first, last, part, pixels);
  }
}

/// Draws those pixels of a face that are in rows `first` to `last`, both included.
void BandRasterizer::draw_face(Index face, int first, int last, const PixelBox& part,
                               FacePixel* pixels) const {
  const Corners corners = corners_of(mesh_.faces[face]);
  if (!is_drawn_(corners)) return;
  FaceSetup setup;
  setup.bounds = bounds_of(mesh_.faces[face], corners, pixels_, width_, height_);
  if (setup.bounds.is_empty()) return;
  setup.functions = functions_of(corners[0], corners[1], corners[2]);
  if (!(setup.functions.depth_numerator > 0)) return;
  const Range& own = setup.bounds.rows;
  for (int y = std::max(first, own.first); y <= std::min(last, own.last); ++y) {
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y - part.first_row) * part.columns();
    draw_row(setup, face, y, pixels + row, part.first_column);
  }
}

FaceBuffer rasterize(const Mesh& mesh, const Camera& camera, Sides sides) {
  // Each band is drawn by one thread, in face order. The last band may end below the picture, where
  // no face has rows.
  FaceBuffer buffer(camera.width, camera.height);
  const BandRasterizer bands(mesh, camera, usual_rows_per_band, sides);
  parallel_for(bands.bands(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t band = first; band < last; ++band)
      bands.draw(band, buffer.row(static_cast<int>(band) * usual_rows_per_band));
  });
  return buffer;
}

}  // namespace transformesh
