// Camera files: cameras that are read can be written in every format, and read again as the same
// cameras.
#include <Eigen/LU>

#include "fuzz/fuzz.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_file.h"
#include "views/cameras/camera_output.h"

using namespace transformesh;
using namespace transformesh::fuzz;

namespace {

/// Returns how far the rows of R are from orthonormal, as in files with few digits.
double rotation_error(const PinholeCamera& camera) {
  const Eigen::Matrix3d product = camera.rotation * camera.rotation.transpose();
  return (product - Eigen::Matrix3d::Identity()).norm();
}

/// Checks how decomposition changed a matrix: not at all unless the matrix is nearly singular.
/// COLMAP makes a rotation of R.
void compare(const CameraRecord& given, const CameraRecord& again) {
  demand_same(given.name, again.name, "another name");
  const Eigen::Matrix<double, 3, 4> a = given.camera.projection();
  const Eigen::Matrix<double, 3, 4> b = again.camera.projection();
  const Eigen::Matrix3d left = a.leftCols<3>().rowwise().normalized();
  if (!(std::abs(left.determinant()) > 0.01) || !a.allFinite()) return;
  const double tolerance = 1e-9 + 100 * rotation_error(given.camera);
  for (int i = 0; i < 3; ++i)
    demand((a - b).leftCols<3>().row(i).norm() <= tolerance * a.leftCols<3>().row(i).norm(),
           "another projection");
  const double distance = given.camera.translation.norm();
  for (int i = 0; i < 3; ++i)
    demand(std::abs((a - b)(i, 3)) <= tolerance * a.leftCols<3>().row(i).norm() * distance,
           "another place");
}

void write_and_compare(const CameraList& list, CameraFormat format) {
  std::string text;
  try {
    text = write_cameras(list, format);
  } catch (const InputError&) {
    return;  // the format cannot represent these cameras
  }
  // A camera of a file with a single matrix has the name of the file.
  const CameraList again = parse_cameras(text, "written.txt", list.cameras.front().name);
  demand(list.cameras.size() == again.cameras.size(), "another number of cameras");
  for (std::size_t i = 0; i < list.cameras.size(); ++i) compare(list.cameras[i], again.cameras[i]);
}

}  // namespace

void transformesh::fuzz::run_target(std::string_view bytes) {
  CameraList list;
  try {
    list = parse_cameras(bytes, "input.txt");
  } catch (const InputError&) {
    return;
  }
  for (const CameraRecord& record : list.cameras) {
    const PinholeCamera& camera = record.camera;
    demand(camera.intrinsics.allFinite() && camera.translation.allFinite(), "no finite number");
    demand(camera.intrinsics(0, 0) > 0 && camera.intrinsics(1, 1) > 0, "a focal length below 0");
    // Rotations with three digits are accepted.
    demand(std::abs(camera.rotation.determinant() - 1) < 0.01, "no rotation");
  }
  for (const CameraFormat format :
       {CameraFormat::middlebury, CameraFormat::colmap, CameraFormat::matrices})
    write_and_compare(list, format);
}
