/// Which faces of a mesh meet all of several conditions: those of select.h (of the floor below)
/// and component_around.h, taken together. Faces and vertices keep their order and columns;
/// vertices that no face uses are dropped. Open meshes and soups do. Deterministic.
/// Cost: O(n log n).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/component_around.h"
#include "mesh/select.h"

namespace transformesh {

/// What is not given is no condition.
struct SelectionOptions {
  std::optional<std::size_t> largest;       ///< the faces of so many components, by size
  double at_least = 0;                      ///< of components at least so large; 0: of any
  ComponentSize by = ComponentSize::faces;  ///< what makes a component large
  std::string where;                        ///< a condition on a column, as faces_where() takes it
  std::optional<Box> box;                   ///< faces with all corners in it
  std::optional<Vec3> around;               ///< the component around this point
  std::optional<std::vector<bool>> mask;    ///< one of each face: those for which it holds
  bool invert = false;                      ///< the other faces instead
};

struct SelectionResult {
  std::size_t selected_faces = 0, dropped_faces = 0;
  std::optional<ComponentAround> around;  ///< of `around`: whether it contains the point
};

/// Throws what the conditions throw, InputError where the mask has another length than there are
/// faces, and GoalError where no face is selected; the mesh is then as it was.
SelectionResult select(Mesh& mesh, const SelectionOptions& options);

}  // namespace transformesh
