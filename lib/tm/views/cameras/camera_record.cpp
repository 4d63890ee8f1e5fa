#include "tm/views/cameras/camera_record.h"

#include <Eigen/LU>

#include "tm/support/error.h"
#include "tm/views/cameras/camera_formats.h"

namespace transformesh {
namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

void CameraRecord::set_size(int columns, int rows, const std::string& image) {
  if (width != 0 && (width != columns || height != rows)) {
    throw InputError("the camera of " + quoted(name) + " is for an image of " +
                     size_text(width, height) + " pixels, but " + image + " has " +
                     size_text(columns, rows) + " (" + place + ")");
  }
  width = columns;
  height = rows;
  if (!is_centered) return;
  camera.intrinsics(0, 2) = (columns - 1) / 2.0;
  camera.intrinsics(1, 2) = (rows - 1) / 2.0;
  is_centered = false;
}

bool is_number(std::string_view word) {
  const char* first = word.data();
  const char* last = first + word.size();
  double value = 0;
  return parse_number(first, last, value) == Parsed::ok && first == last;
}

std::string place_of(const TextRows& rows, const Source& source) {
  return source.name + " line " + std::to_string(source.line_of(rows.place()));
}

void check_intrinsics(const TextRows& rows, const Eigen::Matrix3d& intrinsics,
                      const std::string& who) {
  if (intrinsics(0, 0) <= 0 || intrinsics(1, 1) <= 0) {
    rows.fail("the focal lengths of " + who + " must be positive");
  }
}

void check_rotation(const TextRows& rows, const Eigen::Matrix3d& rotation, const std::string& who) {
  // Files hold rounded numbers, some of three digits.
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
