/// Connected components: faces that share a vertex index are connected.
#pragma once

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

/// The faces for which keep[face] holds, in order, with the vertices that they use, in order, and
/// all columns.
Mesh select_faces(const Mesh& mesh, const std::vector<bool>& keep);

}  // namespace transformesh
