// The poses_bounds.npy of LLFF: for each image a 3x5 matrix and two depths. Reference: Mildenhall,
// Srinivasan, Ortiz-Cayon, Khademi Kalantari, Ramamoorthi, Ng & Kar, "Local light field fusion:
// practical view synthesis with prescriptive sampling guidelines", TOG 38(4), 2019. The manual of
// the program describes the file under "Using your own poses".
#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_pose.h"
#include "views/cameras/npy_array.h"

namespace transformesh {
namespace {

constexpr std::size_t numbers_per_image = 17;  ///< numbers per image: a 3x5 matrix and two depths

int image_side(double value, const char* what, const std::string& who, const Source& source) {
  if (!(value >= 1 && value <= 1e9))
    source.fail("the " + std::string(what) + " of " + who + " is not a size of an image");
  return static_cast<int>(value);
}

/// Reads the 17 numbers of one image. The first three columns of the 3x5 matrix are the camera's
/// axes: down, right and backwards. The fourth is the center. The fifth contains height, width and
/// focal length.
CameraRecord read_image_row(const double* row, const std::string& who, const Source& source) {
  CameraRecord record;
  record.place = source.name + ' ' + who;
  const Eigen::Map<const Eigen::Matrix<double, 3, 5, Eigen::RowMajor>> matrix(row);
  record.height = image_side(matrix(0, 4), "height", who, source);
  record.width = image_side(matrix(1, 4), "width", who, source);
  const double focal = matrix(2, 4);
  record.camera.intrinsics << focal, 0, (record.width - 1) / 2.0, 0, focal,
      (record.height - 1) / 2.0, 0, 0, 1;
  std::string problem = intrinsics_problem(record.camera.intrinsics, who);
  if (!problem.empty()) source.fail(problem);
  Eigen::Matrix3d rotation;
  rotation << matrix.col(1).transpose(), matrix.col(0).transpose(), -matrix.col(2).transpose();
  problem = set_pose_at(rotation, matrix.col(3), who, record.camera);
  if (!problem.empty()) source.fail(problem);
  return record;
}

}  // namespace

CameraList read_llff(const Source& source, const std::string& stem) {
  const NpyArray array = read_npy(source);
  if (array.shape.size() != 2 || array.shape[1] != numbers_per_image)
    source.fail("the NumPy array must have 17 numbers for each image, like poses_bounds.npy");
  CameraList list;
  for (std::size_t i = 0; i < array.shape[0]; ++i) {
    const std::string number = std::to_string(i + 1);
    CameraRecord record =
        read_image_row(array.values.data() + i * numbers_per_image, "row " + number, source);
    record.name = std::string(stem).append("-").append(number);
    list.cameras.push_back(std::move(record));
  }
  if (list.cameras.empty()) source.fail("there is no camera in the file");
  return list;
}

}  // namespace transformesh
