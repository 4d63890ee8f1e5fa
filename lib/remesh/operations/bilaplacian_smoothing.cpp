#include "remesh/operations/bilaplacian_smoothing.h"

#include <cmath>
#include <limits>
#include <vector>

#include "remesh/operations/vertex_mover.h"

namespace transformesh {
namespace {

/// Each vertex moves by this share of the difference of heights. Larger shares even out heights
/// faster and may overshoot.
constexpr double share = 0.3;
/// A vertex that is higher above its neighbors than this share of the edge length is at a crease
/// and does not move.
constexpr double crease = 0.25;
/// Movements shorter than this share of the edge length are skipped.
constexpr double still = 1e-3;
/// The squared edge length of six equal equilateral triangles if the sum of their areas is 1/2.
constexpr double squared_edge_by_area = 0.19245008972987526;

constexpr double not_smooth = std::numeric_limits<double>::quiet_NaN();

struct Vertex {
  Vec3 neighbors = Vec3::Zero();  ///< sum of the neighbors' positions
  /// Sum of the normals of the faces; later the unit vector in this direction.
  Vec3 normal = Vec3::Zero();
  double valence = 0;
  double edge = 0;
  /// Height of the vertex above the mean of its neighbors, along the normal.
  double height = not_smooth;
};

std::vector<Vertex> heights(const EditableMesh& mesh, const VertexRoles& roles) {
  std::vector<Vertex> vertices(mesh.vertex_slots());
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    if (!mesh.has_face(face)) continue;
    const Vec3 normal = mesh.face_normal(face);
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      Vertex& vertex = vertices[mesh.source(h)];
      vertex.neighbors += mesh.position(mesh.target(h));
      vertex.normal += normal;
      ++vertex.valence;
    }
  }
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    Vertex& vertex = vertices[v];
    if (!mesh.has_vertex(v) || roles[v] != VertexRole::free) continue;
    const double area = vertex.normal.norm();
    if (area == 0) continue;
    vertex.normal /= area;
    vertex.edge = std::sqrt(squared_edge_by_area * area);
    const double height = (mesh.position(v) - vertex.neighbors / vertex.valence).dot(vertex.normal);
    if (std::abs(height) < crease * vertex.edge) vertex.height = height;
  }
  return vertices;
}

}  // namespace

void smooth_bilaplacian(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                        const Progress& progress) {
  progress("even out", 0);
  const std::vector<Vertex> vertices = heights(mesh, roles);
  VertexMover mover(mesh, guard);
  VertexStar star;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (v % 8192 == 0) progress("even out", static_cast<double>(v) / mesh.vertex_slots());
    const Vertex& vertex = vertices[v];
    if (std::isnan(vertex.height)) continue;
    double sum = 0;
    mesh.for_each_neighbor(v, [&](Index neighbor, Index) { sum += vertices[neighbor].height; });
    const double way = share * (sum / vertex.valence - vertex.height);
    if (!(std::abs(way) > still * vertex.edge)) continue;
    star.gather(mesh, v);
    mover.move(v, star, star.center() + way * vertex.normal);
  }
}

}  // namespace transformesh
