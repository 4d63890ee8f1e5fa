/// Region growing (paper 3.2): finds the pieces of the closed part of a mesh that bound the region
/// of points p with w(p) >= winding level. Faces that are certainly hidden are not cut. A face that
/// others merely cross is cut only along the boundary of its exterior (exterior_cut.h). In other
/// planes, only exterior facets become pieces. The winding number w in front of a plane is
/// propagated from a corner at which w is known (region_growing_winding.h), or from a ray.
///
/// Open components (open/open_components.h) do not change w. They are cut along all faces that they
/// meet. Their pieces with w < winding level in front are kept.
///
/// Exact; parallel; deterministic for any number of threads. Throws what arrange() throws. In a
/// part of a mesh, only complete faces become pieces; these pieces are those of the whole mesh.
/// Departure from the paper: winding numbers are found for all faces before any face is cut.
#pragma once

#include "clean/arrange/arrange.h"
#include "clean/exterior/surroundings.h"
#include "transformesh/control.h"

namespace transformesh {

struct ExteriorArrangement {
  Arrangement arrangement;
  std::vector<char> kept;       ///< 1 for each piece that is kept
  std::size_t whole_faces = 0;  ///< faces that take part in no intersection, whether kept or not
  std::size_t rays = 0;
  bool has_surface = false;  ///< false if all coincident faces cancel out
};

struct ExteriorArrangementOptions {
  int winding_level = 1;
  bool arranges_everything = false;      ///< also return hidden pieces, which are not kept
  const Surroundings* around = nullptr;  ///< set for a part of a closed mesh, null for a whole mesh
};

/// `meetings` must fulfill the preconditions of arrange().
ExteriorArrangement arrange_exterior(const std::shared_ptr<const WeldedMesh>& welded,
                                     const std::vector<Meeting>& meetings,
                                     const ExteriorArrangementOptions& options,
                                     const Progress& progress);

}  // namespace transformesh
