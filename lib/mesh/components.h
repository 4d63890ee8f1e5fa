/// Connected components: faces that share a vertex index are connected.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

struct Component {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundary_loops = 0;
  double volume = 0;  ///< with sign
  long euler() const {
    return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces);
  }
  /// Of an orientable manifold, borders capped.
  long genus() const { return (2 - euler() - static_cast<long>(boundary_loops)) / 2; }
};

struct Components {
  std::vector<Component> components;  ///< in order of their first face
  std::vector<Index> of_face;         ///< component of each face
  long genus() const;                 ///< of all components
};

Components connected_components(const Mesh& mesh);

/// How a closed oriented manifold hangs together.
struct Connectivity {
  std::vector<Index> opposites;  ///< opposite_halfedges() of adjacency.h
  std::size_t components = 0;
  std::vector<Index> component_of;  ///< of each face; numbered in order of their first face
};

/// Given the opposite halfedges. O(n).
Connectivity connect(std::vector<Index> opposites);

/// The components of the mesh with this connectivity: several times as fast as without.
Components connected_components(const Mesh& mesh, const Connectivity& connectivity);

/// The faces for which keep[face] holds, in order, with the vertices that they use, in order, and
/// all columns.
Mesh select_faces(const Mesh& mesh, const std::vector<bool>& keep);

}  // namespace transformesh
