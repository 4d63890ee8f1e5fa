/// A picture of what an operation changed. The mesh before is to the left, the mesh after to the
/// right. The upper row shows them from the front, the lower row from behind. All panels show the
/// same place at the same scale.
#pragma once

#include <vector>

#include "transformesh/control.h"
#include "transformesh/image.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct ChangePictureOptions {
  int width = 1600;   ///< pixels of the picture; >= 2
  int height = 1200;  ///< >= 2, even
  /// For each face of the mesh before: true if it is lost. For each face of the mesh after: true if
  /// it is new.
  std::vector<char> is_lost{}, is_new{};
};

/// Draws the picture. Lost faces are red, new ones green, and all others gray. Throws InputError
/// for a mesh without faces. Deterministic for any number of threads.
Image draw_change(const Mesh& before, const Mesh& after, const ChangePictureOptions& options,
                  const Progress& progress = {});

}  // namespace transformesh
