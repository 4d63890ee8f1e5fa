/// Finds the exterior patches of a mesh with open components (beyond paper 4.6;
/// docs/design/open-meshes.md has the definition). The pieces are those of
/// exterior/exterior_arrangement.h: the boundary of the closed part, and all pieces of open
/// components. A patch is a set of pieces of one component that are connected across edges through
/// which no other component passes.
///
/// The winding number in front of a patch is a sum of three terms. The first is the winding number
/// of the closed part (the faces that traverse each edge equally often in both directions). The
/// second is the number of other open components behind which the patch is. The third is the
/// winding number of the patch's own component; it is 0 unless the component intersects itself. To
/// decide whether a patch is behind another component, the curves along which both intersect are
/// considered. The patch is behind the component if it is behind it along more than half of the
/// length of these curves. If there are no such curves, but the component intersects other patches
/// of the same component as the patch, its generalized winding number decides. Then the patch is
/// behind it if the median of this number over the area of the patch is at least 1/2. A patch of
/// the closed part can only be behind a body with holes: an open component that encloses most of
/// what it would enclose without its holes.
///
/// Reference: Jacobson, Kavan & Sorkine-Hornung, "Robust inside-outside segmentation using
/// generalized winding numbers", ACM TOG 32(4), 2013. Departure: integer winding numbers and
/// intersection curves decide first. Generalized winding numbers decide only if both leave the
/// decision open.
///
/// Deterministic; independent of the order of faces. Cost: O(n log n), and O(m) for each sample of
/// a generalized winding number of a component with m faces.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"

namespace transformesh {

struct OpenPatches {
  std::vector<char> kept;   ///< 1 for each exterior piece, which is kept
  std::size_t patches = 0;  ///< number of patches (connected pieces between intersection curves)
  /// Number of patches that needed a generalized winding number.
  std::size_t decided_by_number = 0;
  /// Least distance of a used generalized winding number from the nearest value at which it would
  /// be rounded to another integer.
  double least_margin = 0.5;
};

OpenPatches find_exterior_patches(const Arrangement& arrangement, int winding_level);

}  // namespace transformesh
