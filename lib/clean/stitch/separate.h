/// Moves vertices at equal positions apart. Stitching duplicates vertices at places where sheets
/// touch (paper 3.3); these duplicates are called copies. Each copy moves by half of `distance`
/// along the mean normal of its faces, weighted by angle. It moves to the side on which there are
/// no other copies. Hence copies at which two bodies touch move into their own bodies. Copies at
/// which the wall of a cavity touches itself move out of the cavity. A copy between two other
/// copies moves after these have moved. If no side can be determined, for example at the edge of a
/// part thinner than rounding errors, four directions are tried. They are both directions along the
/// mean normal, and both directions along the mean direction into the faces.
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
  /// Distance of two vertices at one position after both moved, in input units; > 0.
  double distance = 0;
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
