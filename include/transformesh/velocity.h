/// Velocities from columns of the mesh, and those of offsetting and of mean-curvature flow.
/// Cost: O(n log n); deterministic.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct VelocityOptions {
  std::optional<std::vector<Vec3>> given;  ///< taken instead of the columns vx, vy and vz
  std::optional<double> normal_speed;      ///< input units per time; negative: inwards
  double curvature_speed = 0;              ///< squared input units per time
  std::string mask;                        ///< vertex column that multiplies the sum; empty: none
};

/// The sum of the velocities given, or else of the columns if the mesh has them, and of those by
/// the two speeds. Throws InputError (no_velocity) if there are none of these, and for a mesh whose
/// border edges coincide if there is a speed. Throws UsageError for a wrong number of velocities.
std::vector<Vec3> velocities_of(const Mesh& mesh, const VelocityOptions& options);

/// The vertex columns vx, vy and vz. Throws InputError naming those that are missing.
std::vector<Vec3> column_velocities(const Mesh& mesh);
bool has_column_velocities(const Mesh& mesh);

/// speed * N(p), N(p) the angle-weighted vertex normal: a positive speed grows a closed mesh.
std::vector<Vec3> normal_velocities(const Mesh& mesh, double speed);

/// Mean-curvature flow: speed * H(p) along the mean-curvature normal, H the mean curvature, so that
/// a sphere of radius r shrinks by speed / r. Reference: Meyer, Desbrun, Schroeder & Barr,
/// "Discrete differential-geometry operators for triangulated 2-manifolds", 2003 (cotangents over
/// mixed areas). Angles count as at least 5 degrees, the weight of an edge as at least 0. Zero on
/// borders and where there is no area.
std::vector<Vec3> curvature_velocities(const Mesh& mesh, double speed);

/// The mean curvature H itself, of the same formula, with a sign: positive where the surface is
/// convex as seen from outside, 1 / r on a sphere of radius r. 0 on borders, where there is no area
/// and where no number holds it.
std::vector<double> mean_curvatures(const Mesh& mesh);

/// Multiplies each velocity by the vertex column of that name: 0 holds a vertex fast. Throws
/// InputError where there is none.
void apply_mask(const Mesh& mesh, std::string_view column, std::vector<Vec3>& velocities);

}  // namespace transformesh
