#include "tm/picture/rasterize.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr int usual_rows_per_band = 16;
constexpr int columns_worth_narrowing = 8;
constexpr std::size_t items_per_task = 4096;

/// A range of pixels from first to last, both included.
struct Range {
  int first = 0;
  int last = -1;
};

}  // namespace

struct FaceSetup {
  EdgeFunctions functions;
  Range columns;
  Range rows;
};

namespace {

/// The integers in [low, high] that are pixels of a row or column.
Range pixels_between(double low, double high, int size) {
  if (!(low <= high)) return {};
  low = std::max(low, 0.0);
  high = std::min(high, size - 1.0);
  if (!(low <= high)) return {};
  return {static_cast<int>(std::ceil(low)), static_cast<int>(std::floor(high))};
}

/// The bounds of the image of a face; the whole image for one that reaches behind the eye.
void find_bounds(const std::array<Vec3, 3>& corners, int width, int height, FaceSetup& setup) {
  Eigen::Array2d low(0, 0);
  Eigen::Array2d high(width - 1, height - 1);
  if (corners[0].z() > 0 && corners[1].z() > 0 && corners[2].z() > 0) {
    low.setConstant(HUGE_VAL);
    high.setConstant(-HUGE_VAL);
    for (const Vec3& corner : corners) {
      const Eigen::Array2d pixel = corner.head<2>().array() / corner.z();
      low = low.min(pixel);
      high = high.max(pixel);
    }
  }
  setup.columns = pixels_between(low.x(), high.x(), width);
  setup.rows = pixels_between(low.y(), high.y(), height);
}

/// Which faces are drawn: where not both sides, those whose corners, projected, have a determinant
/// of the given sign.
struct Drawn {
  bool is_both = true;
  double sign = 0;

  Drawn(const Camera& camera, Sides sides)
      : is_both(sides == Sides::both),
        sign(camera.projection.leftCols<3>().determinant() > 0 ? -1 : 1) {}
  bool operator()(const std::array<Vec3, 3>& corners) const {
    return is_both || sign * corners[0].dot(corners[1].cross(corners[2])) > 0;
  }
};

FaceSetup set_up(const Face& face, const std::vector<Vec3>& projected, const Drawn& is_drawn,
                 int width, int height) {
  FaceSetup setup;
  const std::array<Vec3, 3> corners{projected[face[0]], projected[face[1]], projected[face[2]]};
  if (corners[0].z() <= 0 && corners[1].z() <= 0 && corners[2].z() <= 0) return setup;
  if (!is_drawn(corners)) return setup;
  setup.functions = edge_functions(corners[0], corners[1], corners[2]);
  if (setup.functions.depth_numerator > 0) find_bounds(corners, width, height, setup);
  return setup;
}

/// Sorts faces into the bands of rows that they touch, in face order.
std::vector<std::vector<Index>> faces_of_bands(const std::vector<FaceSetup>& setups, int height,
                                               int rows_per_band) {
  std::vector<std::vector<Index>> bands(
      static_cast<std::size_t>((height + rows_per_band - 1) / rows_per_band));
  for (std::size_t f = 0; f < setups.size(); ++f) {
    const Range& rows = setups[f].rows;
    if (rows.first > rows.last || setups[f].columns.first > setups[f].columns.last) continue;
    for (int band = rows.first / rows_per_band; band <= rows.last / rows_per_band; ++band)
      bands[static_cast<std::size_t>(band)].push_back(static_cast<Index>(f));
  }
  return bands;
}

/// The columns of a row on which all edge functions can be positive, one too many on either side.
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

void draw_row(const FaceSetup& setup, Index face, int y, FacePixel* row) {
  std::array<double, 3> slope;
  std::array<double, 3> start;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& edge = setup.functions.edge[i];
    slope[i] = edge.x();
    start[i] = edge.y() * y + edge.z();
  }
  const bool is_narrow = setup.columns.last - setup.columns.first < columns_worth_narrowing;
  const Range columns = is_narrow ? setup.columns : narrowed(setup.columns, slope, start);
  for (int x = columns.first; x <= columns.last; ++x) {
    const double e0 = slope[0] * x + start[0];
    const double e1 = slope[1] * x + start[1];
    const double e2 = slope[2] * x + start[2];
    const double sum = e0 + e1 + e2;
    if (!(e0 >= 0 && e1 >= 0 && e2 >= 0 && sum > 0)) continue;
    const auto depth = static_cast<float>(setup.functions.depth_numerator / sum);
    FacePixel& pixel = row[x];
    if (pixel.face != no_index && !(depth < pixel.depth)) continue;
    pixel = {face, depth, {static_cast<float>(e0 / sum), static_cast<float>(e1 / sum)}};
  }
}

}  // namespace

EdgeFunctions edge_functions(const Vec3& a, const Vec3& b, const Vec3& c) {
  EdgeFunctions functions;
  const Vec3 across_a = b.cross(c);
  const double determinant = a.dot(across_a);
  if (!(std::abs(determinant) > 0)) return functions;
  const double sign = determinant > 0 ? 1 : -1;
  functions.edge = {sign * across_a, sign * c.cross(a), sign * a.cross(b)};
  functions.depth_numerator = std::abs(determinant);
  return functions;
}

BandRasterizer::BandRasterizer(const Mesh& mesh, const Camera& camera, int rows_per_band,
                               Sides sides)
    : width_(camera.width), rows_per_band_(rows_per_band), setups_(mesh.faces.size()) {
  // Project the corners, and find the edge functions.
  std::vector<Vec3> projected(mesh.positions.size());
  parallel_for(projected.size(), items_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) projected[v] = camera.project(mesh.positions[v]);
  });
  const Drawn is_drawn(camera, sides);
  parallel_for(setups_.size(), items_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      setups_[f] = set_up(mesh.faces[f], projected, is_drawn, camera.width, camera.height);
  });
  faces_ = faces_of_bands(setups_, camera.height, rows_per_band);
}

BandRasterizer::~BandRasterizer() = default;

void BandRasterizer::draw(std::size_t band, FacePixel* rows) const {
  const int first = static_cast<int>(band) * rows_per_band_;
  const int last = first + rows_per_band_ - 1;
  for (const Index face : faces_[band]) {
    const FaceSetup& setup = setups_[face];
    for (int y = std::max(first, setup.rows.first); y <= std::min(last, setup.rows.last); ++y) {
      const auto row = static_cast<std::size_t>(y - first);
      draw_row(setup, face, y, rows + row * static_cast<std::size_t>(width_));
    }
  }
}

FaceBuffer rasterize(const Mesh& mesh, const Camera& camera, Sides sides) {
  // Each band is drawn by one thread, in face order; the last may end below the picture, where no
  // face has rows.
  FaceBuffer buffer(camera.width, camera.height);
  const BandRasterizer bands(mesh, camera, usual_rows_per_band, sides);
  parallel_for(bands.bands(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t band = first; band < last; ++band)
      bands.draw(band, buffer.row(static_cast<int>(band) * usual_rows_per_band));
  });
  return buffer;
}

}  // namespace transformesh
