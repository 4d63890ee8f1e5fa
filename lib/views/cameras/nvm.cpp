// VisualSFM's N-View Match files, NVM_V3. Reference: Wu, "VisualSFM: a visual structure from motion
// system", 2011, manual, "NVM file format".
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_names.h"
#include "views/cameras/camera_pose.h"

namespace transformesh {
namespace {

/// VisualSFM maps a measured point p to the undistorted point p (1 + r |p|^2). Images are resampled
/// by the inverse of this map, approximated by a series up to r^3, whose error is 55 r^4 |p|^8. In
/// the corners of photographs, |p| is up to .6. There the error is .0001 focal lengths if |r|
/// equals this limit. At twice the limit it is more than 10 times as large.
constexpr double most_distortion = 0.1;

/// Intrinsics that the first line of a file may state for all cameras.
struct FixedIntrinsics {
  bool is_given = false;
  Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();
  double distortion = 0;
};

double read_number(TextRows& rows, const char* name, const std::string& who) {
  return rows.finite_number<double>([&] { return name + (" of " + who); });
}

FixedIntrinsics read_fixed_intrinsics(TextRows& rows) {
  FixedIntrinsics fixed;
  rows.next_row();
  rows.word();
  if (rows.word() != "FixedK") return fixed;
  fixed.is_given = true;
  const std::string who = "FixedK";
  fixed.intrinsics(0, 0) = read_number(rows, "fx", who);
  fixed.intrinsics(0, 2) = read_number(rows, "cx", who);
  fixed.intrinsics(1, 1) = read_number(rows, "fy", who);
  fixed.intrinsics(1, 2) = read_number(rows, "cy", who);
  if (rows.has_more()) fixed.distortion = read_number(rows, "r", who);
  check_intrinsics(rows, fixed.intrinsics, who);
  return fixed;
}

LensDistortion nvm_distortion(TextRows& rows, double r, const std::string& who) {
  if (!(std::abs(r) <= most_distortion))
    rows.fail("the radial distortion of " + who + " is more than " +
              std::to_string(most_distortion) + ": undistort the images");
  return {{-r, 3 * r * r, -12 * r * r * r, 0, 0, 0}, {}};
}

Eigen::Matrix3d read_nvm_rotation(TextRows& rows, const std::string& who) {
  Eigen::Quaterniond rotation;
  rotation.w() = read_number(rows, "qw", who);
  rotation.x() = read_number(rows, "qx", who);
  rotation.y() = read_number(rows, "qy", who);
  rotation.z() = read_number(rows, "qz", who);
  // Numbers in files are rounded, some to three digits.
  if (std::abs(rotation.norm() - 1) > 1e-3)
    rows.fail("the quaternion of " + who + " does not have length 1");
  return rotation.normalized().toRotationMatrix();
}

/// Reads the name of an image, in which the file has quotation marks instead of blanks.
std::string read_name(TextRows& rows) {
  std::string name(rows.word());
  std::replace(name.begin(), name.end(), '"', ' ');
  return name;
}

CameraRecord read_nvm_camera(TextRows& rows, const Source& source, const FixedIntrinsics& fixed) {
  CameraRecord record;
  record.name = read_name(rows);
  record.place = place_of(rows, source);
  const std::string who = "camera " + in_quotes(record.name);
  const double focal = read_number(rows, "the focal length", who);
  const Eigen::Matrix3d rotation = read_nvm_rotation(rows, who);
  Vec3 center;
  for (double& coordinate : center) coordinate = read_number(rows, "the center", who);
  const double distortion = read_number(rows, "the radial distortion", who);
  record.distortion = nvm_distortion(rows, fixed.is_given ? fixed.distortion : distortion, who);
  const std::string problem = set_pose_at(rotation, center, who, record.camera);
  if (!problem.empty()) rows.fail(problem);
  record.is_centered = !fixed.is_given;
  record.camera.intrinsics =
      fixed.is_given ? fixed.intrinsics : Eigen::Matrix3d(Vec3(focal, focal, 1).asDiagonal());
  check_intrinsics(rows, record.camera.intrinsics, who);
  rows.skip_row();
  return record;
}

}  // namespace

CameraList read_nvm(const Source& source) {
  TextRows rows(source, 0, rules_without_comments);
  const FixedIntrinsics fixed = read_fixed_intrinsics(rows);
  if (!rows.next_row()) rows.fail("the number of cameras is missing");
  const auto count = rows.number<std::size_t>([] { return std::string("the number of cameras"); });
  rows.end_row([] { return std::string("the number of cameras"); });
  if (count == 0) rows.fail("there is no camera in the file");
  CameraList list;
  list.names_images = true;
  for (std::size_t i = 0; i < count; ++i) {
    if (!rows.next_row())
      rows.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) +
                " cameras");
    list.cameras.push_back(read_nvm_camera(rows, source, fixed));
  }
  remove_common_folder(list);
  return list;
}

}  // namespace transformesh
