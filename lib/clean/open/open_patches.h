/// Which patches of a mesh with open components are exterior (beyond paper 4.6; the definition is
/// in docs/design/open-meshes.md). The pieces are those of exterior/exterior_arrangement.h: the
/// boundary of the closed part, and all of open components. A patch is a set of pieces of one
/// component that are connected across edges which no other component passes through.
///
/// The winding number in front of a patch has three parts. They are that of the closed part, one
/// for each open component that has the patch behind it, and that of the patch's own component. A
/// component has a patch behind it if the patch is on its back along most of the length of their
/// common curves that separate patches. If they have no such curve, but other patches of the
/// component do, its generalized winding number decides: it is above 1/2 over most of the area of
/// the patch. Reference (Jacobson, Kavan & Sorkine-Hornung, "Robust inside-outside segmentation
/// using generalized winding numbers", ACM TOG 32(4), 2013. Only components that intersect
/// themselves have an own number. Only bodies with holes have parts of the closed part behind them:
/// open components that enclose most of what they would enclose if their holes were filled.
///
/// Deterministic; does not depend on the order of the faces. Cost: O(n log n), and O(m) for each
/// sample of a generalized winding number of a component with m faces.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"

namespace transformesh {

struct OpenPatches {
  std::vector<char> kept;             ///< per piece: by the winding level
  std::size_t patches = 0;            ///< how many there are
  std::size_t decided_by_number = 0;  ///< patches whose n depends on a generalized winding number
  double least_margin = 0.5;  ///< how close such a number came to where it would round otherwise
};

OpenPatches find_exterior_patches(const Arrangement& arrangement, int winding_level);

}  // namespace transformesh
