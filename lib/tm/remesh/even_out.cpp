#include "tm/remesh/even_out.h"

#include <cmath>
#include <limits>
#include <vector>

#include "tm/remesh/slab_edits.h"
#include "tm/remesh/vertex_mover.h"

namespace transformesh {
namespace {

constexpr double share = 0.3;
constexpr double crease = 0.25;  ///< of the edge length; a vertex higher than that is at a crease
constexpr double rest = 1e-3;    ///< of the edge length; shorter ways are not gone
/// The squared edge length of six equilateral triangles whose doubled areas sum up to 1.
constexpr double squared_edge_by_area = 0.19245008972987526;

constexpr double not_smooth = std::numeric_limits<double>::quiet_NaN();

struct Vertex {
  Vec3 neighbors = Vec3::Zero();  ///< their sum
  Vec3 normal = Vec3::Zero();     ///< sum of the doubled area normals, then of unit length
  double valence = 0;
  double edge = 0;
  double height = not_smooth;  ///< over the mean of the neighbors
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

void even_out(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
              const Progress& progress) {
  const std::vector<Vertex> vertices = heights(mesh, roles);
  const VertexRings rings(mesh);
  move_vertices(guard, progress, "even out", [&](EmbeddingGuard& own) {
    return [&, mover = VertexMover(mesh, own), star = Star()](Index v) mutable {
      const Vertex& vertex = vertices[v];
      if (std::isnan(vertex.height)) return Moved::not_wanted;
      double sum = 0;  // vertices with a height have no border
      for (const Index neighbor : rings[v].subspan(1)) sum += vertices[neighbor].height;
      const double way = share * (sum / vertex.valence - vertex.height);
      if (!(std::abs(way) > rest * vertex.edge)) return Moved::not_wanted;
      star.gather(mesh, v, rings[v]);
      const Vec3 target = star.center + way * vertex.normal;
      return mover.move(v, star, target) ? Moved::done : Moved::refused;
    };
  });
}

}  // namespace transformesh
