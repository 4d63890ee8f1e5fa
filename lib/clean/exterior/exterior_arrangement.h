/// Region growing (paper 3.2): the pieces of the closed part of a mesh that bound the region of
/// points p with w(p) >= winding level, and no others. What is obviously hidden is not even cut, a
/// face that others merely cross is cut only along what bounds its exterior (exterior_cut.h), and
/// of other planes only the exterior facets become pieces. w in front is carried over a plane from
/// a corner at which it is known (region_growing_winding.h), or from a ray.
///
/// Open components (open/open_components.h) do not change w. They are cut along all that they meet,
/// and each piece of them in front of which w < winding level stays.
///
/// Exact; parallel; deterministic for any number of threads; throws as `arrange` does. Of a part of
/// a mesh, only complete faces become pieces, and these are those of the whole mesh.
#pragma once

#include "clean/arrange/arrange.h"
#include "clean/exterior/surroundings.h"
#include "transformesh/control.h"

namespace transformesh {

struct ExteriorArrangement {
  Arrangement arrangement;
  std::vector<char> kept;       ///< per piece
  std::size_t whole_faces = 0;  ///< that take no part in any intersection, kept or not
  std::size_t rays = 0;
  bool has_surface = false;  ///< faces that lie upon each other do not all cancel out
};

struct ExteriorArrangementOptions {
  int winding_level = 1;
  bool arranges_everything = false;      ///< hidden pieces become pieces too, which are not kept
  const Surroundings* around = nullptr;  ///< of a part of a closed mesh
};

/// `meetings` as for `arrange`.
ExteriorArrangement arrange_exterior(const std::shared_ptr<const WeldedMesh>& welded,
                                     const std::vector<Meeting>& meetings,
                                     const ExteriorArrangementOptions& options,
                                     const Progress& progress);

}  // namespace transformesh
