#include "transformesh/transform.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "mesh/local_measures.h"
#include "mesh/surface_columns.h"
#include "support/elementary/trigonometric.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

using Matrix3 = Eigen::Matrix3d;

/// Tolerance for a scale factor of 1, which products of rotations change by rounding.
constexpr double rounding = 1e-12;

Matrix4 affine(const Matrix3& linear, const Vec3& way) {
  Matrix4 matrix = Matrix4::Identity();
  matrix.topLeftCorner<3, 3>() = linear;
  matrix.topRightCorner<3, 1>() = way;
  return matrix;
}

Matrix3 linear_part(const Matrix4& matrix) { return matrix.topLeftCorner<3, 3>(); }

Vec3 mapped(const Matrix4& matrix, const Vec3& point) {
  return linear_part(matrix) * point + matrix.topRightCorner<3, 1>();
}

Vec3 unit(const Vec3& direction, const char* what) {
  if (direction == Vec3::Zero() || !direction.allFinite())
    throw UsageError(std::string(what) +
                     " has no direction: it needs a finite length other than 0");
  return direction.stableNormalized();
}

/// Returns sine and cosine; exact for multiples of 90 degrees.
std::pair<double, double> sine_and_cosine(double angle_deg) {
  const double turn = std::remainder(angle_deg, 360);
  const double quarters = std::round(turn / 90);
  const double rest = (turn - 90 * quarters) * (std::numbers::pi / 180);
  const double sine = elementary::sin(rest), cosine = elementary::cos(rest);
  switch ((static_cast<int>(quarters) + 4) % 4) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

/// Returns the sign of the determinant, 0 if the matrix is singular. Rows and columns are scaled to
/// about 1 first, so that a strongly anisotropic scaling does not count as singular.
int sign_of_determinant(Matrix3 linear) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double size = linear.row(i).cwiseAbs().maxCoeff();
    if (size == 0) return 0;
    linear.row(i) /= size;
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double size = linear.col(i).cwiseAbs().maxCoeff();
    if (size == 0) return 0;
    linear.col(i) /= size;
  }
  const Eigen::FullPivLU<Matrix3> factors(linear);
  if (!factors.isInvertible()) return 0;
  return factors.determinant() > 0 ? 1 : -1;
}

int checked_sign(const Matrix4& matrix) {
  if (!matrix.allFinite()) throw UsageError("the matrix has numbers that are not finite");
  if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    throw UsageError("the matrix is not affine: its last row must be 0 0 0 1");
  const int sign = sign_of_determinant(linear_part(matrix));
  if (sign == 0) throw UsageError("the matrix is singular: it flattens the mesh");
  return sign;
}

/// Applies `map` to the vectors in three numeric columns, if they exist. Integer columns become
/// doubles.
void map_vectors(Columns& columns, const std::array<const char*, 3>& names, const auto& map) {
  std::array<Column*, 3> found{};
  for (std::size_t i = 0; i < 3; ++i) {
    found[i] = columns.find(names[i]);
    if (found[i] == nullptr || found[i]->list_count_type) return;
  }
  for (Column* column : found) make_floating(*column);
  for (std::size_t row = 0; row < found[0]->values.size(); ++row) {
    const Vec3 vector =
        map(Vec3(found[0]->values[row], found[1]->values[row], found[2]->values[row]));
    for (std::size_t i = 0; i < 3; ++i)
      found[i]->values[row] = vector[static_cast<Eigen::Index>(i)];
  }
}

void map_columns(Mesh& mesh, const Matrix3& linear) {
  const Matrix3 cotangent = (linear / linear.cwiseAbs().maxCoeff()).inverse().transpose();
  const auto map_normal = [&](const Vec3& normal) {
    return Vec3((cotangent * normal).stableNormalized());
  };
  const auto map_velocity = [&](const Vec3& velocity) {
    const Vec3 result = linear * velocity;
    if (velocity.allFinite() && !result.allFinite())
      throw GoalError("a velocity vx vy vz leaves the range of double precision: scale by less");
    return result;
  };
  map_vectors(mesh.vertex_columns, {"vx", "vy", "vz"}, map_velocity);
  map_vectors(mesh.vertex_columns, {"nx", "ny", "nz"}, map_normal);
  map_vectors(mesh.face_columns, {"nx", "ny", "nz"}, map_normal);
}

void turn_faces(Mesh& mesh) {
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
    reverse_corner_lists(mesh, f);
  }
}

}  // namespace

Matrix4 translation_by(const Vec3& way) { return affine(Matrix3::Identity(), way); }

Matrix4 rotation_about(const Vec3& axis, double angle_deg) {
  // Computes the rotation matrix by Rodrigues' formula.
  const Vec3 a = unit(axis, "the axis");
  const auto [sine, cosine] = sine_and_cosine(angle_deg);
  Matrix3 cross;
  cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  const Matrix3 along = a * a.transpose();
  return affine(cosine * Matrix3::Identity() + sine * cross + (1 - cosine) * along, Vec3::Zero());
}

Matrix4 scaling_by(const Vec3& factors) { return affine(factors.asDiagonal(), Vec3::Zero()); }

Matrix4 mirroring_in(const Vec3& normal, double offset) {
  const Vec3 n = unit(normal, "the normal of the mirror");
  const double distance = offset / normal.stableNorm();
  return affine(Matrix3::Identity() - 2 * n * n.transpose(), 2 * distance * n);
}

Matrix4 centering(const Box& box) {
  return translation_by(-(box.min() + (box.max() - box.min()) / 2));
}

Matrix4 fitting_unit_box(const Box& box) {
  const double side = (box.max() - box.min()).maxCoeff();
  if (!(side > 0) || !std::isfinite(1 / side) || !std::isfinite(side))
    throw InputError(
        "the extent of the mesh cannot be scaled to 1: it is zero, or too small or too large");
  const Matrix4 scaling = scaling_by(Vec3::Constant(1 / side));
  return translation_by(Vec3::Constant(0.5)) * scaling * centering(box);
}

Box mapped_box(const Mesh& mesh, const Matrix4& matrix) {
  std::vector<Vec3> points = used_positions(mesh);
  if (points.empty()) points = mesh.positions;
  Box box(Vec3::Zero(), Vec3::Zero());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 point = mapped(matrix, points[i]);
    box.min() = i == 0 ? point : Vec3(box.min().cwiseMin(point));
    box.max() = i == 0 ? point : Vec3(box.max().cwiseMax(point));
  }
  return box;
}

double scale_of(const Matrix4& matrix) {
  const Matrix3 linear = linear_part(matrix);
  const double most = linear.cwiseAbs().maxCoeff();
  if (most == 0) return 0;
  const double scale = most * std::sqrt((linear / most).squaredNorm() / 3);
  return std::abs(scale - 1) <= rounding ? 1 : scale;
}

TransformResult transform(Mesh& mesh, const Matrix4& matrix) {
  const TransformResult result{checked_sign(matrix) < 0, scale_of(matrix)};
  Mesh moved = mesh;
  for (std::size_t v = 0; v < moved.positions.size(); ++v) {
    moved.positions[v] = mapped(matrix, mesh.positions[v]);
    if (!moved.positions[v].allFinite())
      throw GoalError("vertex " + std::to_string(v) +
                      " leaves the range of double precision: scale or move by less");
  }
  map_columns(moved, linear_part(matrix));
  if (result.is_mirror) turn_faces(moved);
  mesh = std::move(moved);
  return result;
}

}  // namespace transformesh
