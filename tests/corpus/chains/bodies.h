/// Random bodies like those of CAD programs: unions and differences of boxes, prisms and cylinders
/// on a common lattice, whose faces touch in common planes. Each body is rotated as a whole by a
/// random angle.
#pragma once

#include "corpus/chains/random.h"
#include "corpus/chains/triangle_mesh.h"

namespace chains {

struct Body {
  TriangleMesh solids;  ///< parts to be united, in one mesh
  TriangleMesh cutter;  ///< parts to be subtracted, with reversed faces; may be empty
  /// Volumes in closed form, in the coordinates before rounding.
  double volume_of_solids = 0;  ///< volume of the union of all solids, before the cut
  double volume = 0;            ///< volume of the solids without the cutter's parts
  double volume_in_two = 0;     ///< volume of the points in at least two solids
  bool is_single_solid = false;
  bool is_rotated = false;
  bool has_coplanar_contact = false;  ///< faces of two parts met in a common plane before rotation
  bool is_flat = false;               ///< the surface bends by at least 45 degrees at all edges
};

/// Returns a body that is not empty. If the cutter would leave less than a tenth of a body, another
/// one is drawn.
Body random_body(Random& random);

}  // namespace chains
