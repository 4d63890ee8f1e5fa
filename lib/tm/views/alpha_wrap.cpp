#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <vector>

#include "tm/mesh/measure.h"
#include "tm/support/error.h"
#include "tm/views/wrap.h"
#include "tm/views/wrap_result.h"

namespace transformesh {
namespace {

constexpr double alpha_by_diagonal = 1.0 / 20;
constexpr double offset_by_diagonal = 1.0 / 300;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

double diagonal_of(std::span<const Vec3> points) {
  Mesh cloud;
  cloud.positions.assign(points.begin(), points.end());
  return bounding_box(cloud).diagonal();
}

}  // namespace

Mesh alpha_wrap(std::span<const Vec3> points, const AlphaWrapOptions& options) {
  if (!(options.alpha >= 0 && options.offset >= 0))
    throw UsageError("alpha and the offset of a wrap must not be negative");
  const double diagonal = diagonal_of(points);
  const double alpha = options.alpha > 0 ? options.alpha : alpha_by_diagonal * diagonal;
  const double offset = options.offset > 0 ? options.offset : offset_by_diagonal * diagonal;
  if (points.empty()) throw InputError("there are no points to wrap");
  if (!(alpha > 0 && offset > 0))
    throw InputError("the points are all in one place: give alpha and the offset as lengths");

  std::vector<Kernel::Point_3> cloud;
  for (const Vec3& point : points) cloud.emplace_back(point.x(), point.y(), point.z());
  Surface surface;
  CGAL::alpha_wrap_3(cloud, alpha, offset, surface);

  Mesh mesh;
  for (const auto vertex : surface.vertices()) {
    const auto& point = surface.point(vertex);
    mesh.positions.emplace_back(point.x(), point.y(), point.z());
  }
  for (const auto face : surface.faces()) {
    Face corners;
    std::size_t i = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face)))
      corners[i++] = static_cast<Index>(vertex.idx());
    mesh.faces.push_back(corners);
  }
  check_wrap(mesh);
  return mesh;
}

}  // namespace transformesh
