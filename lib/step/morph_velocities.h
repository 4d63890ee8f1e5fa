/// Velocities that evolve a surface towards a target (paper 5.2): F(p) = -phi(p) N(p). Here phi is
/// the signed distance to the target, negative inside, and N(p) the angle-weighted vertex normal.
/// The part of the surface outside of the target shrinks, the part inside grows. Reference: Breen &
/// Whitaker, "A level-set approach for the metamorphosis of solid models", TVCG 2001.
///
/// - MorphDistance::vertex is the paper's heuristic: F(p) = ((q - p) . n) N(p), where q is the
///   target vertex nearest to p and n its normal. The target must be sampled as finely as the
///   source. F is zero beside sharp edges.
/// - MorphDistance::points is `vertex` with another sign at points that are farther from the target
///   than its samples are from each other. There the weighted mean of the distances to the tangent
///   planes of twelve vertices decides the side (Kolluri, "Provably good moving least squares",
///   TALG 4(2), 2008). A single plane gives the wrong sign beyond the tip of a thin part, and the
///   surface would move away forever.
/// - MorphDistance::surface: distance to the closest point of the target's faces.
///
/// A component of the target that the source does not overlap is not reached; a component of the
/// source outside of the target shrinks. Cost: O(n log m) for n and m vertices, in parallel.
/// Floating point; deterministic for any number of threads.
#pragma once

#include <limits>
#include <vector>

#include "step/target_query.h"
#include "transformesh/control.h"
#include "transformesh/mesh.h"
#include "transformesh/morph_step.h"

namespace transformesh {
struct MorphVelocityOptions {
  MorphDistance distance = MorphDistance::surface;
  /// MorphDistance::surface estimates |phi| to a few percent if it exceeds this length
  /// (sample_distance.h). Callers set it to the distance beyond which steps are clamped. Input
  /// units.
  double exact_within = std::numeric_limits<double>::infinity();
};

struct MorphVelocities {
  std::vector<Vec3> velocities;  ///< velocity of each vertex of the mesh
  DistanceSummary to_target;     ///< summary of |phi| over the vertices of faces
  /// Thickness of the target at the face or vertex closest to each vertex; infinity beyond
  /// `exact_within`. Empty if the target's thickness is not measured.
  std::vector<double> thickness;
};

/// Returns the vertices of faces along the Hilbert curve (hilbert.h). Other vertices are not part
/// of the surface: they do not move, and no distance counts them.
std::vector<Index> surface_order(const Mesh& mesh);

/// Returns the velocities of a mesh. `order` may be surface_order() of the mesh; if it is empty, it
/// is computed. Throws InputError for a mesh without faces, and UsageError for
/// MorphDistance::surface if the target has no faces.
MorphVelocities morph_velocities(const Mesh& mesh, const TargetQuery& target,
                                 const MorphVelocityOptions& options = {},
                                 const Progress& progress = Progress(),
                                 std::vector<Index> order = {});

/// Summarizes the distances from target vertices to the surface of the mesh, which show the parts
/// of the target that the mesh has not reached. Uses all target vertices, or 513 to 1024 at equal
/// steps of their order if there are more. Only faces around the nearest mesh vertex are tested, so
/// that a distance may be too large by a fraction of an edge. Distances beyond `exact_within` are
/// estimated. Throws InputError for a mesh without faces.
DistanceSummary distance_from_target(const Target& target, const Mesh& mesh,
                                     double exact_within = std::numeric_limits<double>::infinity(),
                                     const Progress& progress = Progress(),
                                     std::vector<Index> order = {});

}  // namespace transformesh
