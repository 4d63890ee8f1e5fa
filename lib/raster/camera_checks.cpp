#include "raster/camera_checks.h"

#include <Eigen/LU>
#include <algorithm>

#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Largest accepted absolute value. Products of three such numbers do not overflow, nor do squares.
constexpr double largest_number = 1e100;
/// Largest accepted ratio of skew and principal point to the focal lengths. Above it, the product
/// of intrinsics and rotation is singular in double precision.
constexpr double most_oblique = 1e12;

bool is_in_range(const Eigen::MatrixXd& numbers) {
  return numbers.allFinite() && numbers.cwiseAbs().maxCoeff() <= largest_number;
}

}  // namespace

std::string place_of(const TextRows& rows, const Source& source) {
  return source.name + " line " + std::to_string(source.line_of(rows.place()));
}

std::string intrinsics_problem(const Eigen::Matrix3d& intrinsics, const std::string& who) {
  const double x = intrinsics(0, 0);
  const double y = intrinsics(1, 1);
  if (x <= 0 || y <= 0) return "the focal lengths of " + who + " must be positive";
  if (!is_in_range(intrinsics) || std::min(x, y) < 1 / largest_number) {
    return "the calibration of " + who + " is out of range: focal lengths are 1e-100 to 1e100";
  }
  if (intrinsics(1, 0) != 0 || intrinsics.row(2) != Eigen::RowVector3d(0, 0, 1))
    return "the calibration of " + who + " must end with 0 0 1 and have 0 below its diagonal";
  const double obliqueness = intrinsics.row(0).norm() / x * (intrinsics.row(1).norm() / y);
  if (obliqueness <= most_oblique) return {};
  return "the calibration of " + who +
         " is singular: its focal lengths are negligible compared with its principal point or skew";
}

std::string translation_problem(const Vec3& translation, const std::string& who) {
  return is_in_range(translation) ? "" : "t of " + who + " is out of range: more than 1e100";
}

void check_intrinsics(const TextRows& rows, const Eigen::Matrix3d& intrinsics,
                      const std::string& who) {
  const std::string problem = intrinsics_problem(intrinsics, who);
  if (!problem.empty()) rows.fail(problem);
}

void check_translation(const TextRows& rows, const Vec3& translation, const std::string& who) {
  const std::string problem = translation_problem(translation, who);
  if (!problem.empty()) rows.fail(problem);
}

void check_read_again(const CameraRecord& record, const PinholeCamera& again) {
  const std::string who = in_quotes(record.name);
  std::string problem = intrinsics_problem(again.intrinsics, who);
  if (problem.empty()) problem = translation_problem(again.translation, who);
  if (!problem.empty()) throw InputError(problem + " (" + record.place + ")");
}

void check_rotation(const TextRows& rows, const Eigen::Matrix3d& rotation, const std::string& who) {
  // Tolerance for the product of the rotation matrix with its transpose. Numbers in files may be
  // rounded to three digits.
  constexpr double rounding = 1e-3;
  const Eigen::Matrix3d product = rotation * rotation.transpose();
  if (!((product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= rounding)) {
    rows.fail("the rotation of " + who + " is not a rotation: its rows are not orthonormal");
  }
  if (rotation.determinant() < 0) {
    rows.fail("the rotation of " + who + " is a reflection: its determinant is -1");
  }
}

}  // namespace transformesh
