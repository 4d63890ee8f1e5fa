/// Finds seams: the curves along which cleaning joined or cut surfaces. A seam is a connected set
/// of vertices. They are new after cleaning, or faces with different component labels meet there.
/// Cost: O(n log n).
#pragma once

#include <set>
#include <vector>

#include "evolution/component_states.h"

namespace transformesh {

struct Seam {
  Extent extent;
  std::set<long> labels;       ///< component labels of the faces at the seam's vertices
  std::set<Index> components;  ///< components of the cleaned mesh that contain the seam's vertices
};

/// Returns the seams, the largest first. Faces of `cleaned` must have the component labels from
/// before cleaning.
std::vector<Seam> find_seams(const Mesh& before, const Mesh& cleaned, const Components& components);

}  // namespace transformesh
