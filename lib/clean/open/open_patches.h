/// Finds the exterior patches of a mesh with open components (beyond paper 4.6;
/// docs/design/open-meshes.md has the definition). The pieces are those of
/// exterior/exterior_arrangement.h: the boundary of the closed part, and all pieces of open
/// components. A patch is a set of pieces of one component that are connected across edges through
/// which no other component passes.
///
/// The winding number in front of a patch is a sum of three terms. The first is the winding number
/// of the closed part (the faces that traverse each edge equally often in both directions). The
/// second is the number of other open components that hide the patch. The third is the number of
/// parts of its own component that hide it; it is 0 unless the component intersects itself
/// (patch_numbers.h computes the second and third).
///
/// Reference: Jacobson, Kavan & Sorkine-Hornung, "Robust inside-outside segmentation using
/// generalized winding numbers", ACM TOG 32(4), 2013. Departure: integer winding numbers and
/// intersection curves decide first. Generalized winding numbers decide only if both leave the
/// decision open.
///
/// Deterministic; independent of the order of faces. Cost: O(n log n), and O(sqrt(m)) for each
/// computed winding number of a component with m faces.
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

/// Curves that end within a few spacings of numbers of type `coordinate` from a border reach it
/// (border_strips.h).
OpenPatches find_exterior_patches(const Arrangement& arrangement, int winding_level,
                                  Scalar coordinate = Scalar::float64);

}  // namespace transformesh
