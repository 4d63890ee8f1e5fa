/// Rigid registration: moves a mesh onto a reference that shows part of the same surface, such as
/// two scans of one object. Pairs sampled points of the mesh with their closest points on the
/// reference. Minimizes the distances from the tangent planes there until the mesh moves no more.
///
/// Robust: each iteration uses the fraction of the pairs with the least fractional root mean square
/// distance. Outliers and parts that only one scan shows therefore do not count. Pairs on the
/// border of the reference, or with normals that point in opposite directions, are left out. This
/// is a local method: it converges from rotations of 20 degrees with offsets of 10 % of the
/// diagonal. Place the mesh roughly first if it is farther away.
///
/// Guarantees: the motion is a rotation and a translation; normals and velocities are rotated too.
/// Deterministic for any number of threads. Cost: O(iterations * samples * log n). References: Chen
/// & Medioni, "Object modelling by registration of multiple range images", Image and Vision
/// Computing 10(3), 1992. Phillips, Liu & Tomasi, "Outlier robust ICP for minimizing fractional
/// RMSD", 3DIM 2007. Turk & Levoy, "Zippered polygon meshes", SIGGRAPH 1994 (borders). Gelfand et
/// al., "Geometrically stable sampling for the ICP algorithm", 3DIM 2003.
#pragma once

#include "transformesh/control.h"
#include "transformesh/transform.h"

namespace transformesh {

struct RegistrationOptions {
  std::size_t samples = 3000;  ///< number of points on the mesh, uniform by area; >= 100
  int iterations = 200;        ///< limit of iterations; >= 1
};

struct RegistrationResult {
  Matrix4 motion = Matrix4::Identity();  ///< maps the input mesh onto the reference
  double rotation_deg = 0;               ///< angle of the motion, from 0 to 180
  /// Root mean square distance of the overlapping samples from the reference; input units.
  double rms = 0;
  double overlap = 0;  ///< fraction of the samples that lie on the reference; [0, 1]
  /// Square root of smallest / largest eigenvalue of the point-to-plane equations; [0, 1]. If it is
  /// near 0, `mesh` can slide along the reference.
  double stability = 0;
  int iterations = 0;
  bool has_converged = false;  ///< the mesh stopped moving within the limit of iterations
};

/// Moves `mesh`. Both meshes may be open and must have the same orientation. A mesh without faces
/// is a point cloud. Its normals are the columns nx ny nz; if the reference lacks them, they are
/// estimated. Throws UsageError for options out of range, InputError if a mesh has no surface, and
/// GoalError if too few points have a usable closest point. `mesh` does not change if the function
/// throws.
RegistrationResult align(Mesh& mesh, const Mesh& reference, const RegistrationOptions& options = {},
                         const Progress& progress = Progress());

}  // namespace transformesh
