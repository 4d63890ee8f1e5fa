/// Connected components: faces that share a vertex index are connected.
#pragma once

#include <span>
#include <vector>

#include "tm/mesh/mesh.h"

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
/// The same of a closed oriented manifold, given its opposite halfedges: several times as fast.
Components connected_components(const Mesh& mesh, std::span<const Index> opposites);

/// How a closed oriented manifold hangs together.
struct Connectivity {
  std::vector<Index> opposites;  ///< opposite_halfedges() of adjacency.h
  Components components;
};

/// The faces for which keep[face] holds, in order, with the vertices that they use, in order, and
/// all columns.
Mesh select_faces(const Mesh& mesh, const std::vector<bool>& keep);

}  // namespace transformesh
