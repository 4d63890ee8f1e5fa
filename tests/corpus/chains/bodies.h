/// Random bodies as CAD programs make them: unions and differences of boxes, prisms and cylinders
/// on a common lattice, whose faces touch in common planes, turned as a whole by a random angle.
#pragma once

#include "corpus/chains/random.h"
#include "corpus/chains/triangle_mesh.h"

namespace chains {

struct Body {
  TriangleMesh solids;  ///< the parts to be united, one after the other
  TriangleMesh cutter;  ///< parts to be taken away, their faces reversed; may be empty
  /// Volumes in closed form, in the coordinates before rounding.
  double volume_of_solids = 0;
  double volume = 0;         ///< without cutter
  double volume_in_two = 0;  ///< of what lies in two solids or more
  bool is_single_solid = false;
  bool is_rotated = false;
  bool has_coplanar_contact = false;  ///< faces of two parts met in a common plane before rotation
  bool is_flat = false;               ///< all edges turn by at least 45 degrees
};

/// Never empty: a body whose cutter leaves less than a tenth of it is drawn again.
Body random_body(Random& random);

}  // namespace chains
