#include "picture/corner_normals.h"

#include <Eigen/Geometry>
#include <numbers>

#include "mesh/adjacency.h"
#include "mesh/disjoint_sets.h"
#include "support/elementary/arctangent.h"
#include "support/elementary/trigonometric.h"
#include "support/parallel.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t faces_per_task = 4096;  ///< affects time only

std::vector<Vec3> unit_normals(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.faces.size());
  parallel_for(normals.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      normals[f] = face_normal(mesh, static_cast<Index>(f)).stableNormalized();
  });
  return normals;
}

/// Joins the corners 3 * face + i that share a normal.
DisjointSets smooth_corners(const Mesh& mesh, const std::vector<Vec3>& normals,
                            double crease_angle_deg) {
  const double flattest = elementary::cos(crease_angle_deg * std::numbers::pi / 180);
  const std::vector<Index> opposites = opposite_halfedges(mesh);
  DisjointSets corners(3 * mesh.faces.size());
  for (Index halfedge = 0; halfedge < opposites.size(); ++halfedge) {
    const Index opposite = opposites[halfedge];
    if (opposite == no_index || opposite < halfedge) continue;
    const Vec3& here = normals[halfedge / 3];
    const Vec3& there = normals[opposite / 3];
    const bool has_area = !here.isZero() && !there.isZero();
    if (has_area && here.dot(there) < flattest) continue;
    corners.join(halfedge, next_halfedge(opposite));
    corners.join(next_halfedge(halfedge), opposite);
  }
  return corners;
}

double corner_angle(const Mesh& mesh, const Face& face, std::size_t corner) {
  const Vec3& apex = mesh.positions[face[corner]];
  const Vec3 u = mesh.positions[face[(corner + 1) % 3]] - apex;
  const Vec3 v = mesh.positions[face[(corner + 2) % 3]] - apex;
  return elementary::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

std::vector<CornerNormals> corner_normals(const Mesh& mesh, double crease_angle_deg) {
  // Weighted normals are summed at the representative corner of each set.
  const std::vector<Vec3> normals = unit_normals(mesh);
  DisjointSets corners = smooth_corners(mesh, normals, crease_angle_deg);
  std::vector<Vec3> sums(3 * mesh.faces.size(), Vec3::Zero());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      sums[corners.find(static_cast<Index>(3 * f + i))] +=
          corner_angle(mesh, mesh.faces[f], i) * normals[f];

  std::vector<CornerNormals> result(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      result[f][i] =
          sums[corners.find(static_cast<Index>(3 * f + i))].stableNormalized().cast<float>();
  return result;
}

}  // namespace transformesh
