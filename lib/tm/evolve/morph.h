/// Velocities that evolve a surface towards a target (paper 5.2): F(p) = -phi(p) N(p), phi being
/// the signed distance to the target, negative inside, and N(p) the angle-weighted vertex normal.
/// What is outside the target shrinks, what is inside grows. Reference for the flow: Breen &
/// Whitaker, "A level-set approach for the metamorphosis of solid models", TVCG 2001.
///
/// - MorphDistance::vertex, the paper's heuristic: with q the target vertex nearest to p and n its
///   normal, F(p) = ((q - p) . n) N(p). It needs a target sampled as finely as the source, and
///   vanishes beside sharp edges.
/// - MorphDistance::surface: phi is the distance to the closest point of the target's faces, its
///   sign by the pseudonormal there (closest_point.h). Needs a target with faces.
///
/// The source finds what it overlaps: a component of the target that lies outside the source stays
/// unfound, and a component of the source outside the target shrinks to nothing.
/// Cost: O(n log m) in parallel; deterministic for any number of threads. Floating point.
#pragma once

#include <limits>
#include <vector>

#include "tm/evolve/target.h"
#include "tm/mesh/mesh.h"
#include "tm/support/progress.h"

namespace transformesh {

enum class MorphDistance { surface, vertex };

struct MorphOptions {
  MorphDistance distance = MorphDistance::surface;
  /// With MorphDistance::surface, |phi| beyond this is estimated, to a few percent
  /// (sample_distance.h): for steps that are clamped there anyway. Input units.
  double exact_within = std::numeric_limits<double>::infinity();
};

struct DistanceSummary {
  double rms = 0;
  double maximum = 0;
};

struct MorphVelocities {
  std::vector<Vec3> velocities;  ///< one per vertex of the mesh
  DistanceSummary to_target;     ///< of |phi| over the vertices of the mesh
  /// Where the target's are known: the narrowest at the closest face or vertex, for every vertex of
  /// the mesh; infinity beyond `exact_within`.
  std::vector<double> gaps;
};

/// Throws InputError for a mesh without faces, UsageError for surface distance to points.
MorphVelocities morph_velocities(const Mesh& mesh, const Target& target,
                                 const MorphOptions& options = {},
                                 const Progress& progress = Progress());

/// From vertices of the target (all, or 513 to 1024 taken evenly from the list of more) to the
/// surface of the mesh: shows what the mesh has missed.
/// Sought on the faces around the mesh's nearest vertex, so a distance can come out too large, by a
/// fraction of an edge on well-shaped meshes; estimated beyond `exact_within`. Throws InputError
/// for a mesh without faces.
DistanceSummary distance_from_target(const Target& target, const Mesh& mesh,
                                     double exact_within = std::numeric_limits<double>::infinity(),
                                     const Progress& progress = Progress());

}  // namespace transformesh
