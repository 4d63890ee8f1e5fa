/// Rigid registration: moves a mesh onto a reference that shows part of the same surface, as two
/// scans of one object do. Pairs sampled points of the mesh with their closest points of the
/// reference, and minimizes the distances from the planes there, until the mesh comes to rest.
///
/// Robust: each iteration uses the share of the pairs with the least fractional root mean square,
/// so that parts that only one scan shows, and outliers, do not count. Pairs on the border of the
/// reference, or whose surfaces face different ways, are left out. A local method: rotations of 20
/// degrees with offsets of 10 % of the diagonal converge; others need a rough placement before.
///
/// Guarantees: the motion is a rotation and a translation; columns follow as in transform().
/// Deterministic for any number of threads. Cost: O(iterations * samples * log n).
/// References: Chen & Medioni, "Object modelling by registration of multiple range images", Image
/// and Vision Computing 10(3), 1992. Phillips, Liu & Tomasi, "Outlier robust ICP for minimizing
/// fractional RMSD", 3DIM 2007. Turk & Levoy, "Zippered polygon meshes", SIGGRAPH 1994 (borders).
/// Gelfand et al., "Geometrically stable sampling for the ICP algorithm", 3DIM 2003.
#pragma once

#include "transformesh/control.h"
#include "transformesh/transform.h"

namespace transformesh {

struct RegistrationOptions {
  std::size_t samples = 3000;  ///< points by area on the mesh; at least 100
  int iterations = 200;        ///< most iterations; at least 1
};

struct RegistrationResult {
  Matrix4 motion = Matrix4::Identity();  ///< maps the mesh as it was onto the reference
  double rotation_deg = 0;               ///< angle of the motion, from 0 to 180
  double rms = 0;      ///< root mean square distance of the overlap from the reference; input units
  double overlap = 0;  ///< share of the samples that lie on the reference, from 0 to 1
  double stability = 0;  ///< least resistance to a motion over the largest, from 0 to 1; 0: slides
  int iterations = 0;
  bool has_converged = false;  ///< the mesh came to rest before the limit of iterations
};

/// Moves the mesh. Meshes may be open, and are oriented alike; without faces they stand for their
/// vertices, whose normals are the columns nx ny nz or are estimated for the reference. Throws
/// UsageError for options out of range, InputError if the mesh or the reference has no surface, and
/// GoalError if too few points find a partner. The mesh does not change if it throws.
RegistrationResult align(Mesh& mesh, const Mesh& reference, const RegistrationOptions& options = {},
                         const Progress& progress = Progress());

}  // namespace transformesh
