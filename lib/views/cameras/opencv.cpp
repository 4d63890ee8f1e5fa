#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <initializer_list>

#include "support/elementary/trigonometric.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/opencv_storage.h"

namespace transformesh {
namespace {

constexpr std::initializer_list<const char*> intrinsics_keys{"camera_matrix", "cameraMatrix", "K",
                                                             "M"};

Eigen::Matrix3d rotation_of_vector(const Vec3& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  const Vec3 axis = vector / angle;
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  // Rodrigues' formula.
  return Eigen::Matrix3d::Identity() + elementary::sin(angle) * cross +
         (1 - elementary::cos(angle)) * cross * cross;
}

LensDistortion opencv_distortion(const OpencvStorage& storage) {
  LensDistortion distortion;
  const auto found = storage.find({"distortion_coefficients", "distCoeffs", "dist_coeffs", "D"});
  if (!found) return distortion;
  // Coefficients after the eighth describe a thin prism and a tilted sensor, which are not
  // supported.
  for (std::size_t i = 8; i < found->size(); ++i)
    if ((*found)[i] != 0)
      storage.fail(
          "distortion beyond k1 k2 p1 p2 k3 k4 k5 k6 is not supported: undistort the "
          "images first");
  auto& [k1, k2, k3, k4, k5, k6] = distortion.radial;
  const std::array order{
      &k1, &k2, distortion.tangential.data(), distortion.tangential.data() + 1, &k3, &k4, &k5, &k6};
  for (std::size_t i = 0; i < std::min(found->size(), order.size()); ++i) *order[i] = (*found)[i];
  return distortion;
}

Eigen::Matrix3d intrinsics_of(const OpencvStorage& storage) {
  const std::vector<double> entries = storage.get(intrinsics_keys);
  if (entries.size() != 9) storage.fail("camera_matrix of the OpenCV file does not have 9 numbers");
  Eigen::Matrix3d k;
  for (int i = 0; i < 9; ++i) k(i / 3, i % 3) = entries[static_cast<std::size_t>(i)];
  const std::string problem = intrinsics_problem(k, "camera_matrix");
  if (!problem.empty()) storage.fail(problem);
  return k;
}

/// Reads a rotation vector and a translation per camera, or the matrix R and t of a single camera.
std::vector<PinholeCamera> poses_of(const OpencvStorage& storage) {
  std::vector<PinholeCamera> poses;
  if (const auto rows = storage.find({"extrinsic_parameters", "extrinsics"})) {
    if (rows->empty() || rows->size() % 6 != 0)
      storage.fail("extrinsic_parameters of the OpenCV file must have rows of 6 numbers");
    for (std::size_t i = 0; i < rows->size(); i += 6) {
      PinholeCamera pose;
      pose.rotation = rotation_of_vector(Vec3(rows->data() + i));
      pose.translation = Vec3(rows->data() + i + 3);
      poses.push_back(pose);
    }
    return poses;
  }
  const std::vector<double> r = storage.get({"R", "rotation", "rvec"});
  const std::vector<double> t = storage.get({"T", "t", "translation", "tvec"});
  if ((r.size() != 9 && r.size() != 3) || t.size() != 3)
    storage.fail("R of the OpenCV file must have 9 numbers or 3, and T 3");
  PinholeCamera pose;
  pose.translation = Vec3(t.data());
  if (r.size() == 3) {
    pose.rotation = rotation_of_vector(Vec3(r.data()));
  } else {
    for (int i = 0; i < 9; ++i) pose.rotation(i / 3, i % 3) = r[static_cast<std::size_t>(i)];
  }
  return {pose};
}

void add_named_matrix(const char* key, int rows, int columns, const std::vector<double>& numbers,
                      TextBuffer& text) {
  text.add(key);
  text.add(": !!opencv-matrix\n   rows: ");
  text.add_number(rows);
  text.add("\n   cols: ");
  text.add_number(columns);
  text.add("\n   dt: d\n   data: [ ");
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) text.add(i % 3 == 0 ? ",\n       " : ", ");
    text.add_decimal(numbers[i]);
  }
  text.add(" ]\n");
}

std::vector<double> numbers_of(const Eigen::Matrix3d& matrix) {
  std::vector<double> numbers;
  for (int i = 0; i < 9; ++i) numbers.push_back(matrix(i / 3, i % 3));
  return numbers;
}

/// Returns k1 k2 p1 p2 k3, followed by k4 k5 k6 if one of these is not 0.
std::vector<double> numbers_of(const LensDistortion& distortion) {
  const auto& k = distortion.radial;
  const auto& [p1, p2] = distortion.tangential;
  std::vector<double> numbers{k[0], k[1], p1, p2, k[2], k[3], k[4], k[5]};
  if (k[3] == 0 && k[4] == 0 && k[5] == 0) numbers.resize(5);
  return numbers;
}

/// Adds a camera to `list` for each pose in the file; all have the same intrinsics and distortion.
void add_cameras(const OpencvStorage& storage, const Source& source, const std::string& name,
                 CameraList& list) {
  CameraRecord record;
  record.camera.intrinsics = intrinsics_of(storage);
  record.distortion = opencv_distortion(storage);
  record.width = storage.side("image_width");
  record.height = storage.side("image_height");
  if (record.width == 0 || record.height == 0) record.width = record.height = 0;
  record.place = source.name;
  const std::vector<PinholeCamera> poses = poses_of(storage);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Matrix3d& r = poses[i].rotation;
    const bool is_rotation = (r * r.transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-4);
    if (!is_rotation || r.determinant() < 0) storage.fail("R of the OpenCV file is not a rotation");
    const std::string problem = translation_problem(poses[i].translation, "the OpenCV file");
    if (!problem.empty()) storage.fail(problem);
    record.camera.rotation = r;
    record.camera.translation = poses[i].translation;
    record.name = poses.size() == 1 ? name : name + '-' + std::to_string(i + 1);
    list.cameras.push_back(record);
  }
}

/// Returns the suffixes of keys in a file of several cameras, one for each camera. These are `0`,
/// `1` and so on, or `_0`, `_1` and so on; the first number may also be 1.
std::vector<std::string> camera_suffixes(const Source& source) {
  for (const char* separator : {"", "_"}) {
    for (const int first : {0, 1}) {
      std::vector<std::string> suffixes;
      for (int i = first; suffixes.size() < OpencvStorage::most_cameras; ++i) {
        const std::string suffix = separator + std::to_string(i);
        if (!OpencvStorage(source, suffix).find(intrinsics_keys)) break;
        suffixes.push_back(suffix);
      }
      if (!suffixes.empty()) return suffixes;
    }
  }
  return {};
}

/// Adds a camera to `list` for each 3x4 matrix in the file, with the key of the matrix as its name.
void add_projections(const Source& source, CameraList& list) {
  const OpencvStorage storage(source);
  for (const std::string& key : storage.matrix_keys()) {
    const auto numbers = storage.find({key.c_str()});
    if (!numbers || numbers->size() != 12) continue;
    CameraRecord record;
    record.name = key;
    record.place = source.name + ' ' + key;
    const Projection projection =
        Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(numbers->data());
    const std::string problem = decompose(projection, key, record.camera);
    if (!problem.empty()) storage.fail(problem);
    list.cameras.push_back(std::move(record));
  }
}

}  // namespace

std::string write_opencv(const CameraRecord& record) {
  const PinholeCamera& camera = record.camera;
  if (camera.intrinsics(0, 1) != 0) {
    throw InputError("the OpenCV camera model has no skew, but the camera of " +
                     in_quotes(record.name) + " has (" + record.place + ")");
  }
  TextBuffer text;
  text.add("%YAML:1.0\n---\n");
  if (record.width > 0) {
    text.add("image_width: ");
    text.add_number(record.width);
    text.add("\nimage_height: ");
    text.add_number(record.height);
    text.add('\n');
  }
  add_named_matrix("camera_matrix", 3, 3, numbers_of(camera.intrinsics), text);
  const std::vector<double> distortion = numbers_of(record.distortion);
  add_named_matrix("distortion_coefficients", static_cast<int>(distortion.size()), 1, distortion,
                   text);
  add_named_matrix("R", 3, 3, numbers_of(camera.rotation), text);
  const Vec3& t = camera.translation;
  add_named_matrix("T", 3, 1, {t.x(), t.y(), t.z()}, text);
  return text.take();
}

CameraList read_opencv(const Source& source, const std::string& stem) {
  CameraList list;
  const OpencvStorage storage(source);
  if (!storage.find(intrinsics_keys)) {
    for (const std::string& suffix : camera_suffixes(source))
      add_cameras(OpencvStorage(source, suffix), source,
                  stem + '-' + suffix.substr(suffix.find_first_not_of('_')), list);
    if (list.cameras.empty()) add_projections(source, list);
  }
  if (list.cameras.empty()) add_cameras(storage, source, stem, list);
  return list;
}

}  // namespace transformesh
