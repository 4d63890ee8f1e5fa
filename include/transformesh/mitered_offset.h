/// Surfaces whose faces have moved along their normals, so that planes stay planes and sharp edges
/// stay sharp. The result is cleaned as by clean(), and parts that turned inside out are dropped.
/// Reference: Garland & Heckbert, "Surface simplification using quadric error metrics", SIGGRAPH
/// 1997: a vertex moves to the point that fits the moved planes of its faces best.
///
/// Guarantees: the result is a closed oriented manifold without self-intersections. Not guaranteed:
/// the distance of each plane. If more than three planes meet at a vertex, they may have no common
/// point; a vertex moves by at most four times the distance. The result says by how much planes
/// miss the distance. Columns are carried as by clean(). Deterministic. Cost: that of clean().
#pragma once

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct MiterDeviation {
  double most = 0;         ///< largest difference of a plane's movement from the distance
  Vec3 at = Vec3::Zero();  ///< the vertex with this difference, before the movement
  bool is_large = false;   ///< over 5 % of the distance, which is more than on smooth surfaces
};

/// Moves a closed surface outwards, or inwards if `distance` is negative. `distance` is in input
/// units. Throws UsageError if it is 0 or not finite, InputError if the mesh is open or not
/// oriented, and GoalError if nothing is left, or as clean() does.
MiterDeviation offset_mitered(Mesh& mesh, double distance, Scalar coordinate = Scalar::float64,
                              const Progress& progress = Progress());

/// Makes a solid around an open sheet: the sheet moves by half of `thickness` to both sides, and
/// walls close the solid along the borders. Throws UsageError if the thickness is not positive,
/// InputError if the mesh is closed or not oriented, or as clean() does.
MiterDeviation thicken(Mesh& mesh, double thickness, Scalar coordinate = Scalar::float64,
                       const Progress& progress = Progress());

}  // namespace transformesh
