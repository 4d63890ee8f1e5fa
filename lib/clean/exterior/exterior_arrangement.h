/// Region growing (paper 3.2): finds the pieces that bound the region of points p with winding
/// number w(p) >= winding level. Only the closed part of the mesh (faces that traverse each edge
/// equally often in both directions) determines w. Faces that are certainly hidden, with no
/// exterior part, are not cut. A face is cut only along the boundary of its exterior part if all
/// other faces merely cross it (exterior_cut.h). All other faces are cut along all intersections,
/// and only their exterior triangles become pieces. The winding number w in front of a face is
/// propagated from a corner at which w is known (region_growing_winding.h), or from a ray.
///
/// Open components (connected faces that do not belong to the closed part; open/open_components.h)
/// do not change w. They are cut along all faces that they meet. Their pieces with w < winding
/// level in front are kept.
///
/// Exact; parallel; deterministic for any number of threads. Throws what arrange() throws. If only
/// a part of a mesh is loaded, only faces with all their surroundings (surroundings.h) become
/// pieces; these pieces are the same as in the whole mesh. Departure from the paper: winding
/// numbers are found for all faces before any face is cut.
#pragma once

#include "clean/arrange/arrange.h"
#include "clean/exterior/surroundings.h"
#include "transformesh/control.h"

namespace transformesh {

struct ExteriorArrangement {
  Arrangement arrangement;
  std::vector<char> kept;       ///< 1 for each piece that is kept in the result
  std::size_t whole_faces = 0;  ///< number of faces without intersections, whether kept or not
  std::size_t rays = 0;
  bool has_surface = false;  ///< false if every face coincides with a face of opposite orientation
};

struct ExteriorArrangementOptions {
  int winding_level = 1;
  bool arranges_everything = false;      ///< also return the pieces that are not kept in the result
  const Surroundings* around = nullptr;  ///< set for a part of a closed mesh, null for a whole mesh
};

/// Arranges the exterior of a welded mesh. `meetings` must fulfill the preconditions of arrange().
ExteriorArrangement arrange_exterior(const std::shared_ptr<const WeldedMesh>& welded,
                                     const std::vector<Meeting>& meetings,
                                     const ExteriorArrangementOptions& options,
                                     const Progress& progress);

}  // namespace transformesh
