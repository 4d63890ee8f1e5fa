#include "mesh/cotangent_laplacian.h"

#include <algorithm>

#include "mesh/edges.h"
#include "mesh/triangle.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Returns the cotangent of the angle opposite to a halfedge in its face.
double opposite_cotangent(const Mesh& mesh, Index halfedge) {
  const Vec3& apex = mesh.positions[halfedge_source(mesh, previous_halfedge(halfedge))];
  return clamped_cotangent(mesh.positions[halfedge_source(mesh, halfedge)] - apex,
                           mesh.positions[halfedge_target(mesh, halfedge)] - apex);
}

/// Returns for each corner of a face the area of the part that is nearest to the corner. If the
/// face is obtuse, half of it belongs to the obtuse corner and a quarter to each of the other
/// corners.
Vec3 corner_areas(const Mesh& mesh, Index face) {
  Vec3 squares;     // squared lengths of the edges from corner i
  Vec3 cotangents;  // cotangents of the angles opposite to the edges from corner i
  for (int i = 0; i < 3; ++i) {
    const Index halfedge = 3 * face + static_cast<Index>(i);
    squares[i] = (mesh.positions[halfedge_target(mesh, halfedge)] -
                  mesh.positions[halfedge_source(mesh, halfedge)])
                     .squaredNorm();
    cotangents[i] = opposite_cotangent(mesh, halfedge);
  }
  Vec3 shares;
  const double area = face_area(mesh, face);
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3;
    const bool is_obtuse_here = cotangents[(i + 1) % 3] < 0;
    shares[i] = cotangents.minCoeff() < 0
                    ? area / (is_obtuse_here ? 2 : 4)
                    : (squares[i] * cotangents[i] + squares[before] * cotangents[before]) / 8;
  }
  return shares;
}

/// Returns the cotangents of the angles opposite the halfedges of a face. They are scaled down
/// together if the face has an angle below 1 degree.
Vec3 scaled_cotangents(const Mesh& mesh, Index face) {
  // The cotangent of 1 degree. Without a bound, the entries of a matrix would differ so much that
  // sums lose digits.
  constexpr double largest = 57.28996163075943;
  const double cross = face_normal(mesh, face).stableNorm();
  Vec3 cotangents = Vec3::Zero();
  if (!(cross > 0)) return cotangents;
  for (int i = 0; i < 3; ++i) {
    const Index halfedge = 3 * face + static_cast<Index>(i);
    const Vec3& apex = mesh.positions[halfedge_source(mesh, previous_halfedge(halfedge))];
    cotangents[i] = (mesh.positions[halfedge_source(mesh, halfedge)] - apex)
                        .dot(mesh.positions[halfedge_target(mesh, halfedge)] - apex) /
                    cross;
  }
  const double size = cotangents.cwiseAbs().maxCoeff();
  if (size > largest) cotangents *= largest / size;
  return cotangents.allFinite() ? cotangents : Vec3::Zero();
}

std::vector<double> halfedge_cotangents(const Mesh& mesh, CotangentBounds bounds) {
  std::vector<double> cotangents;
  cotangents.reserve(3 * mesh.faces.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (bounds == CotangentBounds::each_triangle) {
      const Vec3 scaled = scaled_cotangents(mesh, f);
      cotangents.insert(cotangents.end(), {scaled[0], scaled[1], scaled[2]});
    } else {
      for (Index h = 3 * f; h < 3 * f + 3; ++h) cotangents.push_back(opposite_cotangent(mesh, h));
    }
  }
  return cotangents;
}

}  // namespace

CotangentLaplacian cotangent_laplacian(const Mesh& mesh, CotangentBounds bounds) {
  const std::size_t count = mesh.positions.size();
  CotangentLaplacian result{{}, std::vector<double>(count, 0), std::vector<char>(count, 0)};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 shares = corner_areas(mesh, static_cast<Index>(f));
    for (int i = 0; i < 3; ++i) result.areas[mesh.faces[f][i]] += shares[i];
  }

  const std::vector<double> cotangents = halfedge_cotangents(mesh, bounds);
  const Edges edges(mesh);
  result.edges.reserve(edges.size());
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto halfedges = edges.halfedges(edge);
    const Index from = halfedge_source(mesh, halfedges[0]);
    const Index to = halfedge_target(mesh, halfedges[0]);
    if (halfedges.size() == 1) result.is_border[from] = result.is_border[to] = 1;
    double weight = 0;
    for (const Index halfedge : halfedges) weight += cotangents[halfedge];
    if (bounds == CotangentBounds::each_edge) weight = std::max(weight, 0.0);
    result.edges.push_back({from, to, weight});
  }
  return result;
}

}  // namespace transformesh
