/// Connected components: faces that share a vertex index are connected.
#pragma once

#include <string>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct Component {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundary_loops = 0;
  double volume = 0;  ///< signed volume
  long euler() const {
    return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces);
  }
  /// Genus of an orientable manifold, with its boundary loops capped.
  long genus() const { return (2 - euler() - static_cast<long>(boundary_loops)) / 2; }
};

/// Measure of the size of a component; `volume` is the absolute value.
enum class ComponentSize { faces, area, volume };

struct Components {
  std::vector<Component> components;  ///< ordered by their first face
  std::vector<Index> of_face;         ///< index of the component of each face
  long genus() const;                 ///< sum over all components
};

/// Finds the components. O(n).
Components connected_components(const Mesh& mesh);

/// Returns the measure of this name: faces, area or volume. Throws UsageError for another name.
ComponentSize component_size_of(const std::string& name);

/// Returns a mesh for each component, the largest first; ties are in order of their first face.
/// Faces and vertices keep their order and columns; unused vertices are dropped.
std::vector<Mesh> split_components(const Mesh& mesh, ComponentSize by);

/// Connectivity of a closed oriented manifold.
struct Connectivity {
  std::vector<Index> opposites;  ///< opposite halfedge of each halfedge
  std::size_t components = 0;
  std::vector<Index> component_of;  ///< component of each face; numbered by their first face
};

/// Finds the components from the opposite halfedges. O(n).
Connectivity connect(std::vector<Index> opposites);

/// Returns the components of a mesh with this connectivity; several times as fast as without it.
Components connected_components(const Mesh& mesh, const Connectivity& connectivity);

/// Returns the faces f with keep[f] and their vertices, in the order of `mesh`, with all columns.
Mesh select_faces(const Mesh& mesh, const std::vector<bool>& keep);

}  // namespace transformesh
