#include "transformesh/components.h"

#include <cmath>
#include <utility>

#include "mesh/connected_minima.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"
#include "mesh/local_measures.h"
#include "mesh/umbrellas.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Returns six times the signed volume of the tetrahedron of face and reference point.
double volume_under_face(const Mesh& mesh, const Face& face, const Vec3& reference) {
  const Vec3 a = mesh.positions[face[0]] - reference;
  const Vec3 b = mesh.positions[face[1]] - reference;
  const Vec3 c = mesh.positions[face[2]] - reference;
  return a.dot(b.cross(c));
}

/// Finds the components, in order of their first face.
Components numbered_components(const Mesh& mesh) {
  DisjointSets vertices(mesh.positions.size());
  for (const Face& face : mesh.faces) {
    vertices.join(face[0], face[1]);
    vertices.join(face[0], face[2]);
  }
  Components result;
  std::vector<Index> of_root(mesh.positions.size(), no_index);
  for (const Face& face : mesh.faces) {
    Index& component = of_root[vertices.find(face[0])];
    if (component == no_index) {
      component = static_cast<Index>(result.components.size());
      result.components.emplace_back();
    }
    result.of_face.push_back(component);
  }
  return result;
}

/// Returns the center of the bounding box of the vertices that faces use.
Vec3 middle_of(const Mesh& mesh, const std::vector<char>& is_used) {
  Box box(Vec3::Zero(), Vec3::Zero());
  bool is_empty = true;
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (!is_used[v]) continue;
    const Vec3& point = mesh.positions[v];
    if (is_empty) box = {point, point};
    is_empty = false;
    box.min() = box.min().cwiseMin(point);
    box.max() = box.max().cwiseMax(point);
  }
  return box.min() + (box.max() - box.min()) / 2;
}

/// Computes the volume of each component as volume() computes that of a mesh. Each sum is divided
/// only once, so that the volume of a box with integer coordinates is exact.
void add_volumes(const Mesh& mesh, const std::vector<char>& is_used, Components& result) {
  if (const int exponent = extreme_exponent(mesh); exponent != 0) {
    add_volumes(scaled_down(mesh, exponent), is_used, result);
    for (Component& component : result.components)
      component.volume = std::ldexp(component.volume, 3 * exponent);
    return;
  }
  const Vec3 reference = middle_of(mesh, is_used);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    result.components[result.of_face[f]].volume +=
        volume_under_face(mesh, mesh.faces[f], reference);
  for (Component& component : result.components) component.volume /= 6;
}

/// Counts faces and vertices, and sums the volumes, of each component.
void count_faces(const Mesh& mesh, Components& result) {
  std::vector<char> is_used(mesh.positions.size(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    Component& component = result.components[result.of_face[f]];
    ++component.faces;
    for (const Index vertex : mesh.faces[f]) {
      component.vertices += is_used[vertex] ? 0 : 1;
      is_used[vertex] = 1;
    }
  }
  add_volumes(mesh, is_used, result);
}

}  // namespace

Components connected_components(const Mesh& mesh) {
  Components result = numbered_components(mesh);
  count_faces(mesh, result);

  // An edge or a boundary loop belongs to the component of any of its faces.
  const Edges edges(mesh);
  const auto component_of = [&](Index halfedge) -> Component& {
    return result.components[result.of_face[halfedge / 3]];
  };
  bool is_closed = true;
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto halfedges = edges.halfedges(edge);
    ++component_of(halfedges[0]).edges;
    is_closed = is_closed && halfedges.size() != 1;
  }
  if (is_closed) return result;
  for (const Index halfedge : boundary_loops(edges, find_umbrellas(mesh, edges)))
    ++component_of(halfedge).boundary_loops;
  return result;
}

// In a manifold, faces of one component are connected across edges.
Connectivity connect(std::vector<Index> opposites) {
  RawVector<Index> of_face =
      connected_minima(opposites.size() / 3, [&](Index face, const auto& visit) {
        for (Index h = 3 * face; h < 3 * face + 3; ++h) visit(opposites[h] / 3);
      });
  const std::size_t count = number_components(of_face, [](Index) { return true; }).size();
  return {std::move(opposites), count, {of_face.begin(), of_face.end()}};
}

Components connected_components(const Mesh& mesh, const Connectivity& connectivity) {
  Components result;
  result.components.resize(connectivity.components);
  result.of_face = connectivity.component_of;
  count_faces(mesh, result);
  for (Component& component : result.components) component.edges = component.faces / 2 * 3;
  return result;
}

long Components::genus() const {
  long sum = 0;
  for (const Component& component : components) sum += component.genus();
  return sum;
}

Mesh select_faces(const Mesh& mesh, const std::vector<bool>& keep) {
  std::vector<Index> kept_faces;
  std::vector<Index> new_vertex(mesh.positions.size(), no_index);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (!keep[f]) continue;
    kept_faces.push_back(static_cast<Index>(f));
    for (const Index vertex : mesh.faces[f]) new_vertex[vertex] = 0;
  }
  std::vector<Index> kept_vertices;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (new_vertex[v] == no_index) continue;
    new_vertex[v] = static_cast<Index>(kept_vertices.size());
    kept_vertices.push_back(static_cast<Index>(v));
  }

  Mesh result;
  result.positions.reserve(kept_vertices.size());
  for (const Index vertex : kept_vertices) result.positions.push_back(mesh.positions[vertex]);
  result.faces.reserve(kept_faces.size());
  for (const Index f : kept_faces) {
    const Face& face = mesh.faces[f];
    result.faces.push_back({new_vertex[face[0]], new_vertex[face[1]], new_vertex[face[2]]});
  }
  result.vertex_columns = mesh.vertex_columns.select(kept_vertices);
  result.face_columns = mesh.face_columns.select(kept_faces);
  return result;
}

}  // namespace transformesh
