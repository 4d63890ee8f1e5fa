/// Velocities that evolve a surface towards a target (paper 5.2): F(p) = -phi(p) N(p), phi being
/// the signed distance to the target, negative inside, and N(p) the angle-weighted vertex normal.
/// What is outside the target shrinks, what is inside grows (Breen & Whitaker, "A level-set
/// approach for the metamorphosis of solid models", TVCG 2001).
///
/// - MorphDistance::vertex, the paper's heuristic: with q the target vertex nearest to p and n its
///   normal, F(p) = ((q - p) . n) N(p). It needs a target sampled as finely as the source, and
///   vanishes beside sharp edges.
/// - MorphDistance::points: the same, but farther away than samples are from each other the mean
///   over twelve planes decides on the side (Kolluri, "Provably good moving least squares", TALG
///   4(2), 2008): one alone errs beyond the tip of a limb, and the surface runs away there.
/// - MorphDistance::surface: to the closest point of the target's faces (closest_point.h).
///
/// A component of the target outside the source stays unfound; one of the source outside shrinks.
/// Cost: O(n log m) in parallel; deterministic for any number of threads. Floating point.
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
  /// With MorphDistance::surface, |phi| beyond this is estimated, to a few percent
  /// (sample_distance.h): for steps that are clamped there anyway. Input units.
  double exact_within = std::numeric_limits<double>::infinity();
};

struct MorphVelocities {
  std::vector<Vec3> velocities;  ///< one per vertex of the mesh
  DistanceSummary to_target;     ///< of |phi| over the vertices of the mesh
  /// Of the closest face or vertex of the target, where the target's is measured; infinity beyond
  /// `exact_within`.
  std::vector<double> thickness;
};

/// `order`: hilbert_order() of the vertices, if it is known. Throws InputError for a mesh without
/// faces, UsageError for surface distance to points.
MorphVelocities morph_velocities(const Mesh& mesh, const TargetQuery& target,
                                 const MorphVelocityOptions& options = {},
                                 const Progress& progress = Progress(),
                                 std::vector<Index> order = {});

/// Distances from vertices of the target (all, or 513 to 1024 taken evenly from the list of more)
/// to the surface of the mesh, which show what the mesh has missed. Only faces around the nearest
/// vertex of the mesh are looked at, so that a distance may be too large by a fraction of an edge;
/// beyond `exact_within` distances are estimated. Throws InputError for a mesh without faces.
DistanceSummary distance_from_target(const Target& target, const Mesh& mesh,
                                     double exact_within = std::numeric_limits<double>::infinity(),
                                     const Progress& progress = Progress(),
                                     std::vector<Index> order = {});

}  // namespace transformesh
