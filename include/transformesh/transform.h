/// Affine maps of meshes, as 4x4 matrices that act on columns (x, y, z, 1).
///
/// Guarantees: vertices, faces and columns keep their order. Normals (nx ny nz of vertices and
/// faces) are mapped by the inverse transpose and get unit length. Velocities (vx vy vz of
/// vertices) are mapped by the linear part, as displacements are. If they are integers, they become
/// doubles. Other columns stay. A negative determinant (mirror image) reverses faces and their
/// corner lists, so that the outside stays outside. The mesh may be open or a soup. Floating point,
/// the same on every machine. Cost: O(n).
#pragma once

#include <Eigen/Core>

#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {

using Matrix4 = Eigen::Matrix4d;

/// These functions throw UsageError for an axis or a normal of length 0.
Matrix4 translation_by(const Vec3& way);
/// Rotation about an axis through the origin, counter-clockwise seen from the tip of the axis, in
/// degrees. Quarter turns about coordinate axes are exact.
Matrix4 rotation_about(const Vec3& axis, double angle_deg);
Matrix4 scaling_by(const Vec3& factors);
/// Reflection in the plane normal * x = offset.
Matrix4 mirroring_in(const Vec3& normal, double offset);
/// Moves the center of the box to the origin.
Matrix4 centering(const Box& box);
/// Scales the longest side to 1 and centers the box in [0, 1]^3. Throws InputError if the box has
/// no size.
Matrix4 fitting_unit_box(const Box& box);

/// Returns the box of the mapped vertices that faces use, or of all vertices if there is no face.
Box mapped_box(const Mesh& mesh, const Matrix4& matrix);

/// Returns the root mean square of the singular values of the linear part: the factor of a uniform
/// scaling. Exactly 1 if the deviation from 1 is within rounding.
double scale_of(const Matrix4& matrix);

struct TransformResult {
  bool is_mirror = false;  ///< faces were reversed
  double scale = 1;        ///< uniform scale factor of the matrix, from scale_of()
};

/// Throws UsageError for a matrix that is singular, not finite, or not affine (last row 0 0 0 1).
/// Throws GoalError if a result is not finite. The mesh does not change if the function throws.
TransformResult transform(Mesh& mesh, const Matrix4& matrix);

}  // namespace transformesh
