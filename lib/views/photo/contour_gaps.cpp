#include "views/photo/contour_gaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "raster/camera.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/contour_distance.h"

namespace transformesh {
namespace {

/// A vertex that projects next to the background is on the rim unless it is hidden. It counts as
/// hidden if the visible surface around it is nearer to the camera by more than this, in units of a
/// pixel's side. Near a contour, the depth of a surface changes by less. A larger value also
/// accepts vertices behind another part of the surface; a smaller one rejects rims of flat
/// surfaces.
constexpr double pixels_of_curvature = 20;

/// Vertices with larger pixel coordinates are ignored: no image has such pixels, and their
/// coordinates may not fit in an integer.
constexpr double most_pixels = 1e9;

/// Bits that say whether a camera observes front sides or back sides of faces at a vertex.
enum Facing : char { unseen = 0, front = 1, back = 2, both = 3 };

/// Returns for each marked vertex which sides of its faces a camera at `eye` observes.
std::vector<char> facings(const Mesh& mesh, const Vec3& eye, const std::vector<char>& is_marked) {
  std::vector<char> result(mesh.positions.size(), unseen);
  for (const Face& face : mesh.faces) {
    if (is_marked[face[0]] == 0 && is_marked[face[1]] == 0 && is_marked[face[2]] == 0) continue;
    const Vec3 a = mesh.positions[face[0]] - eye;
    const Vec3 b = mesh.positions[face[1]] - eye;
    const Vec3 c = mesh.positions[face[2]] - eye;
    const char facing = a.dot(b.cross(c)) < 0 ? front : back;
    for (const Index vertex : face) result[vertex] = static_cast<char>(result[vertex] | facing);
  }
  return result;
}

/// The pixels that show the surface and whose eight neighbors all show the surface.
class InnerPixels {
 public:
  explicit InnerPixels(const VisibleDepths& depths) : box_(depths.box()) {
    GrayImage room;
    const GrayImage& framed = depths.framed(room);
    if (framed.width < 3 || framed.height < 3) return;
    is_inner_ = Raster<char>(box_.columns(), box_.rows(), 1);
    for (int y = 0; y < box_.rows(); ++y)
      for (int above = 0; above <= 2; ++above) keep_inner(framed.row(y + above), is_inner_.row(y));
  }

  bool has(int x, int y) const {
    const int column = x - box_.first_column;
    const int row = y - box_.first_row;
    return column >= 0 && column < is_inner_.width && row >= 0 && row < is_inner_.height &&
           is_inner_.at(column, row) != 0;
  }

 private:
  void keep_inner(const float* depths, char* is_inner) const {
    for (int x = 0; x < box_.columns(); ++x) {
      const bool is_seen = (depths[x] > 0) & (depths[x + 1] > 0) & (depths[x + 2] > 0);
      is_inner[x] = static_cast<char>(is_inner[x] & static_cast<char>(is_seen));
    }
  }

  PixelBox box_;
  Raster<char> is_inner_;
};

/// True if a pixel next to (x, y) shows background and the surface at `depth` can border on it.
/// False if the visible surface around (x, y) is nearer to the camera than `depth` by more than
/// `pixels_of_curvature`. In this case, another part of the surface borders on the background.
bool borders_on_background(const VisibleDepths& depths, const PackableImage& image, double x,
                           double y, double depth, double pixel) {
  const int column = static_cast<int>(std::lround(x));
  const int row = static_cast<int>(std::lround(y));
  bool has_background = false;
  double farthest = 0;
  for (int i = std::max(row - 1, 0); i <= std::min(row + 1, image.height - 1); ++i) {
    for (int j = std::max(column - 1, 0); j <= std::min(column + 1, image.width - 1); ++j) {
      const float seen = depths.at(j, i);
      has_background = has_background || seen == 0;
      farthest = std::max(farthest, static_cast<double>(seen));
    }
  }
  return has_background && farthest > depth - pixels_of_curvature * pixel;
}

/// A vertex inside of a silhouette that is next to the background of the surface's image.
struct RimVertex {
  std::size_t vertex;
  double gap;  ///< signed distance from the contour in input units, < 0
};

/// True if a point at pixel (x, y) is so far inside the contour that every interpolated distance
/// around this pixel is negative. Interpolation is then not necessary.
template <class Distances>
bool is_deep_inside(const Distances& distances, int x, int y) {
  // The limit exceeds the sum of four terms. Distances at neighboring pixels differ by up to
  // sqrt(2). Their errors are some hundredths of a pixel. Rounding to a pixel adds half a pixel.
  // One pixel is the tolerance for silhouettes that are not exact.
  constexpr float deep_px = -4;
  return x >= 0 && y >= 0 && x < distances.width && y < distances.height &&
         distances.at(x, y) < deep_px;
}

template <class Distances>
void add_gaps_of_view(const Mesh& mesh, const View& view, const VisibleDepths& depths,
                      const Distances& distances, SilhouetteMeaning meaning, ContourGaps& gaps) {
  const Projection projection = view.camera.projection();
  const double focal = view.camera.focal_length();
  const InnerPixels inner(depths);
  std::vector<RimVertex> rim;
  std::vector<char> is_marked(mesh.positions.size(), 0);
  const bool is_exact = meaning == SilhouetteMeaning::exact;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 q = projection.leftCols<3>() * mesh.positions[v] + projection.col(3);
    if (!(q.z() > 0)) continue;
    const double x = q.x() / q.z();
    const double y = q.y() / q.z();
    if (!(std::abs(x) < most_pixels && std::abs(y) < most_pixels)) continue;
    const bool is_inner = inner.has(static_cast<int>(x + 0.5), static_cast<int>(y + 0.5));
    // This quick test suffices for most vertices: they are neither outside nor on the rim.
    if (is_inner && is_deep_inside(distances, static_cast<int>(x), static_cast<int>(y))) continue;
    const double slack = is_exact ? 0 : q.z() / focal;
    const double gap = distance_at(distances, x, y) * q.z() / focal + slack;
    if (!std::isfinite(gap)) continue;
    if (gap >= 0) {
      if (is_exact) gaps.outside[v] = std::max(gaps.outside[v], gap);
    } else if (!is_inner && borders_on_background(depths, view.image, x, y, q.z(), q.z() / focal)) {
      rim.push_back({v, gap});
      is_marked[v] = 1;
    }
  }
  const std::vector<char> facing = facings(mesh, view.camera.center(), is_marked);
  for (const auto& [v, gap] : rim) {
    if (facing[v] != both) continue;
    gaps.inside[v] -= gap;
    ++gaps.rims[v];
  }
}

}  // namespace

ContourGaps contour_gaps(const Mesh& mesh, std::span<const View> views, const SeenViews& seen,
                         std::span<const PackableImage> distances, SilhouetteMeaning meaning) {
  const std::size_t count = mesh.positions.size();
  ContourGaps gaps{std::vector<double>(count, 0), std::vector<double>(count, 0),
                   std::vector<Index>(count, 0)};
  GrayImage room;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (distances[i].empty()) continue;
    if (distances[i].is_packed())
      add_gaps_of_view(mesh, views[i], seen.depths(i), distances[i], meaning, gaps);
    else
      add_gaps_of_view(mesh, views[i], seen.depths(i), distances[i].unpacked(room), meaning, gaps);
  }
  return gaps;
}

}  // namespace transformesh
