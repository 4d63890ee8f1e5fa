/// Curves along which cleaning joined and cut surfaces: the connected sets of vertices that are new
/// after cleaning, or at which faces with different labels meet. Cost: O(n log n).
#pragma once

#include <set>
#include <vector>

#include "evolution/component_states.h"

namespace transformesh {

struct Seam {
  Extent extent;
  std::set<long> labels;       ///< of the faces at its vertices
  std::set<Index> components;  ///< components of the cleaned mesh
};

/// Returns the seams, the largest first. `cleaned` has the labels of the faces before cleaning.
std::vector<Seam> find_seams(const Mesh& before, const Mesh& cleaned, const Components& components);

}  // namespace transformesh
