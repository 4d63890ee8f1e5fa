/// The pieces of a closed mesh that bound the region of points p with w(p) >= winding level, and no
/// others (paper 3.2): what is obviously hidden is not even cut, a face that others merely cross is
/// cut only along what bounds its exterior (exterior_cut.h), and of other planes only the exterior
/// facets become pieces. w in front is carried over a plane from a corner at which it is known
/// (region_growing_winding.h), or from a ray. Exact; parallel; deterministic for any
/// number of threads; throws as `arrange` does. Of a part of a mesh, only complete faces become
/// pieces, and these are those of the whole mesh.
#pragma once

#include "clean/arrange/arrange.h"
#include "clean/exterior/surroundings.h"
#include "support/progress.h"

namespace transformesh {

struct ExteriorArrangement {
  Arrangement arrangement;
  std::size_t whole_faces = 0;  ///< that take no part in any intersection, kept or not
  std::size_t rays = 0;
};

/// `meetings` as for `arrange`.
ExteriorArrangement arrange_exterior(const std::shared_ptr<const WeldedMesh>& welded,
                                     const std::vector<Meeting>& meetings, int winding_level,
                                     const Progress& progress,
                                     const Surroundings* around = nullptr);

}  // namespace transformesh
