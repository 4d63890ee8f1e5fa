#include "picture/ambient_occlusion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/search/bvh.h"
#include "support/elementary/trigonometric.h"
#include "support/parallel.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr int directions = 128;  ///< more directions reduce noise and take proportionally more time
constexpr std::size_t vertices_per_task = 256;  ///< affects time only

/// Returns one of evenly distributed directions: equidistant heights, rotated by the golden angle.
Vec3 direction(int i) {
  const double height = 1 - (2.0 * i + 1) / directions;
  const double radius = std::sqrt(1 - height * height);
  const double turn = 2 * std::numbers::pi * std::fmod(i / std::numbers::phi, 1.0);
  return {radius * elementary::cos(turn), radius * elementary::sin(turn), height};
}

/// Casts parallel rays. The mesh is rotated so that rays point upwards. A ray is then an
/// axis-aligned box of zero width for the Bvh query.
class ParallelRays {
 public:
  ParallelRays(const Mesh& mesh, const Vec3& upwards)
      : mesh_(mesh), turned_(turned(mesh, upwards)), frame_(turned_) {
    std::vector<FloatBox> boxes;
    boxes.reserve(mesh.faces.size());
    for (const auto& [a, b, c] : mesh.faces) {
      const Vec3 &p = turned_[a], &q = turned_[b], &r = turned_[c];
      boxes.push_back(frame_.box(p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)));
    }
    bvh_ = Bvh(boxes);
  }

  /// True if the ray from the vertex meets a face that is not incident to the vertex.
  bool is_blocked(Index vertex, double least) const {
    FloatBox ray = frame_.box(turned_[vertex], turned_[vertex]);
    ray.max()[2] = std::numeric_limits<float>::infinity();
    bool is_blocked = false;
    bvh_.visit_overlaps(ray, [&](Index f) {
      const Face& face = mesh_.faces[f];
      const bool is_own = std::find(face.begin(), face.end(), vertex) != face.end();
      is_blocked = !is_own && height_above(face, turned_[vertex]) > least;
      return !is_blocked;
    });
    return is_blocked;
  }

 private:
  static std::vector<Vec3> turned(const Mesh& mesh, const Vec3& upwards) {
    const Vec3 across = upwards.unitOrthogonal();
    const Vec3 along = upwards.cross(across);
    std::vector<Vec3> points;
    points.reserve(mesh.positions.size());
    for (const Vec3& p : mesh.positions)
      points.emplace_back(across.dot(p), along.dot(p), upwards.dot(p));
    return points;
  }

  /// Returns the height of the face above the point; -1 if the face is neither above nor below it.
  double height_above(const Face& face, const Vec3& point) const {
    const Vec3 a = turned_[face[0]] - point;
    const Vec3 b = turned_[face[1]] - point;
    const Vec3 c = turned_[face[2]] - point;
    const double of_a = b.x() * c.y() - b.y() * c.x();
    const double of_b = c.x() * a.y() - c.y() * a.x();
    const double of_c = a.x() * b.y() - a.y() * b.x();
    const bool is_inside =
        (of_a >= 0 && of_b >= 0 && of_c >= 0) || (of_a <= 0 && of_b <= 0 && of_c <= 0);
    const double sum = of_a + of_b + of_c;
    if (!is_inside || sum == 0) return -1;
    return (of_a * a.z() + of_b * b.z() + of_c * c.z()) / sum;
  }

  const Mesh& mesh_;
  std::vector<Vec3> turned_;
  BoxFrame frame_;
  Bvh bvh_;
};

}  // namespace

void set_openness(Mesh& mesh, const std::string& column, const Progress& progress) {
  const std::vector<Vec3> normals = vertex_normals(mesh);
  // Least distance of occluders from a vertex, as a fraction of the bounding box's diagonal.
  constexpr double least_distance = 1e-5;
  const double least = least_distance * diagonal_of(bounding_box(mesh));
  const std::size_t count = mesh.positions.size();
  std::vector<double> reached(count, 0.0);
  std::vector<double> all(count, 0.0);
  for (int i = 0; i < directions; ++i) {
    progress("occlusion", static_cast<double>(i) / directions);
    const Vec3 upwards = direction(i);
    const ParallelRays rays(mesh, upwards);
    parallel_for(count, vertices_per_task, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) {
        const double weight = normals[v].dot(upwards);
        if (!(weight > 0)) continue;
        all[v] += weight;
        if (!rays.is_blocked(static_cast<Index>(v), least)) reached[v] += weight;
      }
    });
  }
  Column& openness = mesh.vertex_columns.get(column, Scalar::float32, count);
  for (std::size_t v = 0; v < count; ++v)
    openness.values[v] = all[v] > 0 ? static_cast<float>(reached[v] / all[v]) : 1;
}

}  // namespace transformesh
