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

/// Depth tolerance for vertices next to the background, in pixels. Near a contour a surface curves
/// away from the camera by less than this. A larger value also accepts vertices behind a near part
/// of the surface; a smaller one rejects rims of blunt surfaces.
constexpr double pixels_of_curvature = 20;

/// Sides of the faces around a vertex that a camera observes, as bits.
enum Facing : char { unseen = 0, front = 1, back = 2, both = 3 };

std::vector<char> facings(const Mesh& mesh, const Vec3& eye) {
  std::vector<char> result(mesh.positions.size(), unseen);
  for (const Face& face : mesh.faces) {
    const Vec3 a = mesh.positions[face[0]] - eye;
    const Vec3 b = mesh.positions[face[1]] - eye;
    const Vec3 c = mesh.positions[face[2]] - eye;
    const char facing = a.dot(b.cross(c)) < 0 ? front : back;
    for (const Index vertex : face) result[vertex] = static_cast<char>(result[vertex] | facing);
  }
  return result;
}

/// True if a pixel next to (x, y) shows background and a point at `depth` can border on it. Returns
/// false if the surface around (x, y) is nearer to the camera than the point by more than
/// `pixels_of_curvature`. Another part of the surface then borders on the background.
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

void add_view(const Mesh& mesh, const View& view, const VisibleDepths& depths,
              const PackableImage& distances, SilhouetteMeaning meaning, ContourGaps& gaps) {
  const Projection projection = view.camera.projection();
  const double focal = view.camera.focal_length();
  const std::vector<char> facing = facings(mesh, view.camera.center());
  const bool is_exact = meaning == SilhouetteMeaning::exact;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 q = projection.leftCols<3>() * mesh.positions[v] + projection.col(3);
    if (!(q.z() > 0)) continue;
    const double x = q.x() / q.z();
    const double y = q.y() / q.z();
    const double slack = is_exact ? 0 : q.z() / focal;
    const double gap = distance_at(distances, x, y) * q.z() / focal + slack;
    if (!std::isfinite(gap)) continue;
    if (gap >= 0) {
      if (is_exact) gaps.outside[v] = std::max(gaps.outside[v], gap);
    } else if (facing[v] == both &&
               borders_on_background(depths, view.image, x, y, q.z(), q.z() / focal)) {
      gaps.inside[v] -= gap;
      ++gaps.rims[v];
    }
  }
}

}  // namespace

ContourGaps contour_gaps(const Mesh& mesh, std::span<const View> views, const SeenViews& seen,
                         std::span<const PackableImage> distances, SilhouetteMeaning meaning) {
  const std::size_t count = mesh.positions.size();
  ContourGaps gaps{std::vector<double>(count, 0), std::vector<double>(count, 0),
                   std::vector<Index>(count, 0)};
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!distances[i].empty())
      add_view(mesh, views[i], seen.depths(i), distances[i], meaning, gaps);
  }
  return gaps;
}

}  // namespace transformesh
