/// Affine maps of meshes, as 4x4 matrices that act on columns (x, y, z, 1).
///
/// Guarantees: vertices, faces and columns keep their order. Normals (nx ny nz of vertices and
/// faces) follow by the inverse transpose and get unit length; velocities (vx vy vz of vertices)
/// follow by the linear part, as displacements do; other columns stay. A mirror image (negative
/// determinant) has its faces turned, corner lists with them, so that the outside stays outside.
/// Open meshes and soups do. Floating point, the same on every machine. Cost: O(n).
#pragma once

#include <Eigen/Core>

#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {

using Matrix4 = Eigen::Matrix4d;

/// These throw UsageError for an axis or a normal of length 0.
Matrix4 translation_by(const Vec3& way);
/// Counter-clockwise seen from the tip of the axis, through the origin. Degrees; quarter turns
/// about coordinate axes are exact.
Matrix4 rotation_about(const Vec3& axis, double angle_deg);
Matrix4 scaling_by(const Vec3& factors);
/// In the plane normal * x = offset.
Matrix4 mirroring_in(const Vec3& normal, double offset);
/// Moves the center of the box to the origin.
Matrix4 centering(const Box& box);
/// Scales so that the longest side is 1, and centers within [0, 1]^3. Throws InputError where the
/// box has no size.
Matrix4 fitting_unit_box(const Box& box);

/// Of the vertices that faces use (of all, where there is no face), as the matrix maps them.
Box mapped_box(const Mesh& mesh, const Matrix4& matrix);

/// Root mean square of the factors by which lengths grow along the principal directions: that of
/// a uniform scaling. 1 where it is 1 but for rounding.
double scale_of(const Matrix4& matrix);

struct TransformResult {
  bool is_mirror = false;  ///< faces were turned
  double scale = 1;        ///< scale_of()
};

/// Throws UsageError for a matrix that is singular, not finite, or not affine (last row 0 0 0 1),
/// and GoalError where a result is not finite; the mesh is then as it was.
TransformResult transform(Mesh& mesh, const Matrix4& matrix);

}  // namespace transformesh
