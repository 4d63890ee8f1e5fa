/// Where the velocities of an evolution come from when no program of ours computes them.
/// Cost: O(n); deterministic.
#pragma once

#include <string_view>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// The vertex columns vx, vy and vz. Throws InputError naming those that are missing.
std::vector<Vec3> column_velocities(const Mesh& mesh);
bool has_column_velocities(const Mesh& mesh);

/// speed * N(p), N(p) the angle-weighted vertex normal: a positive speed grows a closed mesh.
std::vector<Vec3> normal_velocities(const Mesh& mesh, double speed);

/// Multiplies each velocity by the vertex column of that name: 0 holds a vertex fast. Throws
/// InputError where there is none.
void apply_mask(const Mesh& mesh, std::string_view column, std::vector<Vec3>& velocities);

}  // namespace transformesh
