#include "clean/rounding/unsplittable_edges.h"

#include "mesh/edges.h"

namespace transformesh {
namespace {

bool is_unsplittable(const Vec3& a, const Vec3& b, Scalar type) {
  const Vec3 middle = rounded_to(Vec3(0.5 * (a + b)), type);
  return middle == a || middle == b;
}

}  // namespace

bool contract_unsplittable_edges(Assembly& assembly, bool moves_input, Scalar type,
                                 Displacement& moved) {
  Mesh& mesh = assembly.mesh;
  const Edges edges(mesh);
  std::vector<char> is_moved(mesh.positions.size(), 0);
  Displacement most;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.halfedges(e).size() <= 2) continue;
    const Index h = edges.halfedges(e)[0];
    Index stays = halfedge_source(mesh, h), goes = halfedge_target(mesh, h);
    if (assembly.vertex_is_new[stays]) std::swap(stays, goes);
    if (!assembly.vertex_is_new[goes] && !moves_input) continue;
    const Vec3 &to = mesh.positions[stays], from = mesh.positions[goes];
    if (is_moved[stays] || is_moved[goes] || !is_unsplittable(from, to, type)) continue;
    most.note((to - from).stableNorm(), spacing_around(from, type));
    mesh.positions[goes] = to;
    is_moved[stays] = is_moved[goes] = assembly.vertex_is_new[goes] = 1;
  }
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const Index v : mesh.faces[f])
      if (is_moved[v]) assembly.face_is_new[f] = 1;
  moved += most;
  return most.length > 0;
}

}  // namespace transformesh
