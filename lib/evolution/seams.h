/// Finds seams: the curves along which cleaning joined or cut surfaces. A seam is a connected set
/// of vertices that are new after cleaning or at which faces with different labels meet. Cost: O(n
/// log n).
#pragma once

#include <set>
#include <vector>

#include "evolution/component_states.h"

namespace transformesh {

struct Seam {
  Extent extent;
  std::set<long> labels;       ///< labels of the faces at its vertices
  std::set<Index> components;  ///< components of the cleaned mesh at its vertices
};

/// Returns the seams, the largest first. Faces of `cleaned` have the labels from before cleaning.
std::vector<Seam> find_seams(const Mesh& before, const Mesh& cleaned, const Components& components);

}  // namespace transformesh
