/// Putting shapes together from parts.
#pragma once

#include <Eigen/Core>

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Rotations about skew axes, a different one for each index: parts that are turned by them meet in
/// general position. Square roots only, hence the same on every machine.
Eigen::Matrix3d generic_rotation(unsigned index);

/// Moves every vertex p to linear * p + offset.
void transform(Mesh& mesh, const Eigen::Matrix3d& linear, const Vec3& offset);

/// Appends the faces of `part`.
void append(Mesh& mesh, const Mesh& part);

}  // namespace transformesh::shapes
