/// Velocities of vertices: from columns of the mesh, along normals (offsetting), and of
/// mean-curvature flow. Cost: O(n log n); deterministic.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct VelocityOptions {
  std::optional<std::vector<Vec3>> given;  ///< velocities instead of the columns vx, vy and vz
  /// Speed along normals; input units per time; negative: inwards.
  std::optional<double> normal_speed;
  /// Factor of mean curvature; squared input units per time.
  double curvature_speed = 0;
  std::string mask;  ///< vertex column that multiplies the sum of all velocities; empty: none
};

/// Returns the sum of the velocities of both speeds and of `given`, or else of the columns if the
/// mesh has any of them. Throws InputError (no_velocity) if there is neither a velocity nor a
/// speed. Throws InputError if only some of the columns exist, or if a speed is set and border
/// edges of the mesh coincide. Throws UsageError for a wrong number of velocities.
std::vector<Vec3> velocities_of(const Mesh& mesh, const VelocityOptions& options);

/// Returns the vertex columns vx, vy and vz. Throws InputError naming the missing ones.
std::vector<Vec3> column_velocities(const Mesh& mesh);
/// Returns true if the mesh has at least one of these columns.
bool has_column_velocities(const Mesh& mesh);

/// Returns speed * N(p), where N(p) is the angle-weighted vertex normal. A positive speed enlarges
/// a closed mesh.
std::vector<Vec3> normal_velocities(const Mesh& mesh, double speed);

/// Mean-curvature flow: speed * H(p) along the mean-curvature normal, H being the mean curvature,
/// so that a sphere of radius r shrinks by speed / r. Reference: Meyer, Desbrun, Schroeder & Barr,
/// "Discrete differential-geometry operators for triangulated 2-manifolds", 2003 (cotangents over
/// mixed areas). Angles are clamped to at least 5 degrees, edge weights to at least 0. Zero on
/// borders and where the area is 0.
std::vector<Vec3> curvature_velocities(const Mesh& mesh, double speed);

/// Returns the signed mean curvature H that curvature_velocities() uses. H is positive where the
/// surface is convex as seen from outside, and 1 / r on a sphere of radius r. H is 0 on borders,
/// where the area is 0, and if it overflows.
std::vector<double> mean_curvatures(const Mesh& mesh);

/// Multiplies each velocity by the vertex column of that name; a value of 0 fixes the vertex.
/// Throws InputError if there is no such column.
void apply_mask(const Mesh& mesh, std::string_view column, std::vector<Vec3>& velocities);

}  // namespace transformesh
