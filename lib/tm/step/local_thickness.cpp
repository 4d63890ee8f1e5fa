#include "tm/step/local_thickness.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "tm/geometry/search/closest_point.h"
#include "tm/geometry/search/kd_tree.h"
#include "tm/mesh/measure.h"
#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t vertices_per_task = 64;
/// A ball that is still not empty after so many cuts is taken as it is.
constexpr int most_cuts = 20;
/// A contact counts where it is deeper inside the ball than this share of the radius: the flat
/// faces around a vertex cut off that much where they are tilted by 18 degrees.
constexpr double depth = 0.05;
constexpr double facing = -0.5;  ///< cosine of 120 degrees
constexpr double wide = std::numeric_limits<double>::infinity();

struct Contact {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};
using Search = std::function<Contact(const Vec3& center)>;

/// The diameter of the ball that touches `point` with its center along `direction`; `normal` is
/// that of the surface there.
double ball_width(const Vec3& point, const Vec3& direction, const Vec3& normal, double reach,
                  const Search& closest) {
  double radius = reach / 2;
  double width = wide;
  for (int cut = 0; cut < most_cuts; ++cut) {
    const Vec3 center = point + radius * direction;
    const Contact contact = closest(center);
    if ((contact.point - center).norm() > (1 - depth) * radius) return width;

    // The next ball passes through that contact too. A contact behind the point is on the other
    // side of the surface.
    const Vec3 way = contact.point - point;
    const double ahead = way.dot(direction);
    if (!(ahead > 0)) return width;
    radius = way.squaredNorm() / (2 * ahead);
    width = contact.normal.dot(normal) < facing ? 2 * radius : wide;
  }
  return width;
}

std::vector<double> widths_at(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                              double reach, const Search& closest) {
  std::vector<double> widths(points.size(), wide);
  parallel_for(points.size(), vertices_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v)
      for (const double side : {1.0, -1.0}) {
        const Vec3 direction = side * normals[v];
        widths[v] =
            std::min(widths[v], ball_width(points[v], direction, normals[v], reach, closest));
      }
  });
  return widths;
}

}  // namespace

std::vector<double> local_thickness(const Target& target, double reach, const Progress& progress) {
  progress("gaps");
  const Mesh& mesh = target.mesh;
  if (target.is_mesh()) {
    const ClosestPointQuery query(mesh, target.face_order);
    return widths_at(mesh.positions, vertex_normals(mesh), reach, [&](const Vec3& center) {
      const ClosestPoint found = query(center);
      return Contact{found.point, found.pseudonormal};
    });
  }
  const KdTree tree(mesh.positions);
  return widths_at(mesh.positions, target.normals, reach, [&](const Vec3& center) {
    const Index nearest = tree.nearest(center);
    return Contact{mesh.positions[nearest], target.normals[nearest]};
  });
}

}  // namespace transformesh
