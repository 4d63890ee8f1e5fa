/// Separates vertices at equal positions, which stitching creates where sheets touch (paper 3.3).
/// Each copy moves by half the distance along the mean normal of its faces, weighted by angle. The
/// direction is towards the side without other copies. Copies at which bodies touch move into their
/// own bodies; copies at which a cavity touches its wall move out of the cavity. A copy between two
/// other copies waits until these have moved. If no side can be determined, for example at a blade
/// thinner than rounding, four directions are tried. They are both directions along the normal, and
/// both along the mean direction into the faces.
///
/// Guarantees: if the mesh has no self-intersections, the result has none, exactly and in the
/// coordinates as written. No normal is reversed, no face loses its area, and no face passes
/// through another. A step that would violate this is halved up to ten times; then the vertex
/// stays. No vertex moves to the position of another vertex. Vertices on borders stay. Only
/// positions change. The volume changes by at most a third of each step times the area around its
/// vertex.
///
/// Cost: O(n log n), and about 0.1 ms per vertex on usual meshes. Deterministic; one thread.
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct SeparateOptions {
  double distance = 0;  ///< distance of two copies after they moved, in input units; > 0
  Scalar coordinate = Scalar::float64;  ///< type in which positions will be written
};

struct SeparateResult {
  std::size_t separated_vertices = 0;  ///< number of moved vertices
  /// Number of vertices that are still at the position of another vertex.
  std::size_t refused_vertices = 0;
};

SeparateResult separate(Mesh& mesh, const SeparateOptions& options,
                        const Progress& progress = Progress());

}  // namespace transformesh
