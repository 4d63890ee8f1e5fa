/// Assembles shapes from parts.
#pragma once

#include <Eigen/Core>

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Returns a rotation about a skew axis, different for each index. Parts rotated by different
/// indices meet in general position. Uses only square roots, hence the result is the same on every
/// machine.
Eigen::Matrix3d generic_rotation(unsigned index);

/// Moves every vertex p to linear * p + offset.
void transform(Mesh& mesh, const Eigen::Matrix3d& linear, const Vec3& offset);

/// Appends the vertices and faces of `part`.
void append(Mesh& mesh, const Mesh& part);

}  // namespace transformesh::shapes
