#include <Eigen/Geometry>
#include <algorithm>

#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

bool is_same_lens(const CameraRecord& a, const CameraRecord& b) {
  return a.camera.intrinsics == b.camera.intrinsics && a.distortion == b.distortion &&
         a.width == b.width && a.height == b.height;
}

/// Appends the distortion coefficients in the order of COLMAP's model FULL_OPENCV.
void add(const LensDistortion& distortion, TextBuffer& text) {
  const auto& [k1, k2, k3, k4, k5, k6] = distortion.radial;
  const auto& [p1, p2] = distortion.tangential;
  for (const double value : {k1, k2, p1, p2, k3, k4, k5, k6}) {
    text.add(' ');
    text.add_number(value);
  }
}

}  // namespace

std::size_t lens_of(const CameraList& list, const CameraRecord& record) {
  const auto first =
      std::find_if(list.cameras.begin(), list.cameras.end(),
                   [&](const CameraRecord& other) { return is_same_lens(other, record); });
  return static_cast<std::size_t>(first - list.cameras.begin());
}

void check_sized_pinhole(const CameraRecord& record, const std::string& program) {
  if (record.width == 0) {
    throw InputError(program + " needs the sizes of the images, which are not known for " +
                     in_quotes(record.name) + " (" + record.place + "): name the images");
  }
  if (record.camera.intrinsics(0, 1) != 0) {
    throw InputError("the " + program + " camera model has no skew, but the camera of " +
                     in_quotes(record.name) + " has (" + record.place + ")");
  }
  PinholeCamera again = record.camera;
  again.intrinsics.col(2).head<2>().array() += pixel_center;
  again.intrinsics.col(2).head<2>().array() -= pixel_center;
  check_read_again(record, again);
}

std::string write_colmap_cameras(const CameraList& list) {
  TextBuffer text;
  text.add("# CAMERA_ID MODEL WIDTH HEIGHT FX FY CX CY\n");
  for (std::size_t i = 0; i < list.cameras.size(); ++i) {
    const CameraRecord& record = list.cameras[i];
    check_sized_pinhole(record, "COLMAP");
    if (lens_of(list, record) != i) continue;
    const Eigen::Matrix3d& k = record.camera.intrinsics;
    text.add_number(i + 1);
    const LensDistortion& distortion = record.distortion;
    text.add(distortion.is_none() ? " PINHOLE " : " FULL_OPENCV ");
    text.add_number(record.width);
    text.add(' ');
    text.add_number(record.height);
    for (const double value : {k(0, 0), k(1, 1), k(0, 2) + pixel_center, k(1, 2) + pixel_center}) {
      text.add(' ');
      text.add_number(value);
    }
    if (!distortion.is_none()) add(distortion, text);
    text.add('\n');
  }
  return text.take();
}

std::string write_colmap_images(const CameraList& list) {
  TextBuffer text;
  text.add("# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then a line of points\n");
  for (std::size_t i = 0; i < list.cameras.size(); ++i) {
    const CameraRecord& record = list.cameras[i];
    Eigen::Quaterniond q(record.camera.rotation);
    q.normalize();
    if (q.w() < 0) q.coeffs() *= -1;
    const Vec3& t = record.camera.translation;
    text.add_number(i + 1);
    for (const double value : {q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()}) {
      text.add(' ');
      text.add_number(value);
    }
    text.add(' ');
    text.add_number(lens_of(list, record) + 1);
    text.add(' ');
    text.add(record.name);
    text.add("\n\n");
  }
  return text.take();
}

}  // namespace transformesh
