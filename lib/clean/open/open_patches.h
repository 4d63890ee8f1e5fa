/// Finds the exterior patches of a mesh with open components (beyond paper 4.6;
/// docs/design/open-meshes.md has the definition). The pieces are those of
/// exterior/exterior_arrangement.h: the boundary of the closed part, and all pieces of open
/// components. A patch is a set of pieces of one component that are connected across edges through
/// which no other component passes.
///
/// The winding number in front of a patch is a sum of three terms. The first is the winding number
/// of the closed part. The second is the number of open components behind which the patch is. The
/// third is the winding number of the patch's own component. A patch is behind another component if
/// it is behind it along most of the length of their common curves that separate patches. If the
/// patch has no such curve, but other patches of its component do, the generalized winding number
/// of the other component decides. Then the median of this number over the area of the patch must
/// be above 1/2. The third term is 0 unless the component intersects itself. Patches of the closed
/// part are only behind bodies with holes. These are open components that enclose most of what they
/// would enclose with filled holes.
///
/// Reference: Jacobson, Kavan & Sorkine-Hornung, "Robust inside-outside segmentation using
/// generalized winding numbers", ACM TOG 32(4), 2013. Here integer winding numbers and curves
/// decide first. Generalized winding numbers decide only if these leave a choice.
///
/// Deterministic; independent of the order of faces. Cost: O(n log n), and O(m) for each sample of
/// a generalized winding number of a component with m faces.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"

namespace transformesh {

struct OpenPatches {
  std::vector<char> kept;             ///< 1 for each exterior piece
  std::size_t patches = 0;            ///< number of patches
  std::size_t decided_by_number = 0;  ///< patches for which a generalized winding number was needed
  /// Least distance of a generalized winding number from the value at which its rounding changes.
  double least_margin = 0.5;
};

OpenPatches find_exterior_patches(const Arrangement& arrangement, int winding_level);

}  // namespace transformesh
