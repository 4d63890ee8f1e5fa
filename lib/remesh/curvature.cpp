#include "remesh/curvature.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/elementary/arctangent.h"
#include "support/elementary/trigonometric.h"

namespace transformesh {
namespace {

/// The largest magnitude of an eigenvalue of a symmetric matrix, by the roots of its characteristic
/// polynomial: Smith, "Eigenvalues of a symmetric 3 x 3 matrix", CACM 4(4), 1961.
double spectral_radius(const Eigen::Matrix3d& matrix) {
  const double scale = matrix.cwiseAbs().maxCoeff();
  if (!(scale > 0)) return 0;
  const Eigen::Matrix3d scaled = matrix / scale;
  const double mean = scaled.trace() / 3;
  const Eigen::Matrix3d deviation = scaled - mean * Eigen::Matrix3d::Identity();
  const double spread = std::sqrt(deviation.squaredNorm() / 6);
  if (!(spread > 0)) return scale * std::abs(mean);
  const Eigen::Matrix3d unit = deviation / spread;
  const double cosine = std::clamp(unit.determinant() / 2, -1.0, 1.0);
  const double angle = elementary::atan2(std::sqrt((1 - cosine) * (1 + cosine)), cosine) / 3;
  const double largest = mean + 2 * spread * elementary::cos(angle);
  const double smallest = mean + 2 * spread * elementary::cos(angle + 2 * std::numbers::pi / 3);
  return scale * std::max(largest, -smallest);
}

/// The curvature tensor integrated over a part of the surface, and the area of that part.
struct Bending {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  double area = 0;

  void add(const Bending& other) {
    tensor += other.tensor;
    area += other.area;
  }
  double largest() const { return area > 0 ? spectral_radius(tensor) / area : 0; }
};

/// The angle between the normals of the two faces at an edge, positive if the edge is convex.
double bend_angle(const EditableMesh& mesh, Index halfedge, const Vec3& unit_edge) {
  const Vec3 here = mesh.face_normal(halfedge / 3);
  const Vec3 there = mesh.face_normal(mesh.opposite(halfedge) / 3);
  return elementary::atan2(here.cross(there).dot(unit_edge), here.dot(there));
}

/// Returns the area of a face and its curvature tensor. Each edge contributes half of its tensor;
/// the other half belongs to the other face at the edge.
Bending bending_of(const EditableMesh& mesh, Index face) {
  Bending bending;
  bending.area = 0.5 * mesh.face_normal(face).norm();
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    if (mesh.is_border(h) || mesh.is_feature(h)) continue;
    const Vec3 edge = mesh.position(mesh.target(h)) - mesh.position(mesh.source(h));
    const double length = edge.norm();
    if (length == 0) continue;
    const double angle = bend_angle(mesh, h, edge / length);
    bending.tensor += 0.5 * angle / length * edge * edge.transpose();
  }
  return bending;
}

}  // namespace

std::vector<double> largest_curvatures(const EditableMesh& mesh) {
  std::vector<Bending> rings(mesh.vertex_slots());
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    if (!mesh.has_face(face)) continue;
    const Bending bending = bending_of(mesh, face);
    for (Index h = 3 * face; h < 3 * face + 3; ++h) rings[mesh.source(h)].add(bending);
  }

  // The curvature of a single one-ring depends strongly on its triangulation. Therefore the
  // one-rings of the neighbors are added.
  std::vector<double> curvatures(mesh.vertex_slots(), 0);
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.has_vertex(v)) continue;
    Bending around = rings[v];
    mesh.for_each_neighbor(v, [&](Index neighbor, Index) { around.add(rings[neighbor]); });
    curvatures[v] = around.largest();
  }
  return curvatures;
}

}  // namespace transformesh
