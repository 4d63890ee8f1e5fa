#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/little_endian.h"

namespace transformesh {
namespace {

void add_text(std::string_view text, LittleEndianWriter& bytes) {
  bytes.add(std::uint64_t{text.size()});
  bytes.add(text);
}

/// Appends the numbers of a matrix, row by row.
void add_matrix(const Eigen::MatrixXd& matrix, LittleEndianWriter& bytes) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) bytes.add(matrix(i, j));
}

void add_counted(const std::vector<std::string>& items, LittleEndianWriter& bytes) {
  bytes.add(std::uint64_t{items.size()});
  for (const std::string& item : items) bytes.add(std::string_view(item));
}

/// Returns the bytes of a platform, OpenMVS's name for a camera rig. The rig has a single camera,
/// whose coordinate system equals that of the rig.
std::string platform_bytes(const CameraRecord& record) {
  LittleEndianWriter bytes;
  add_text("", bytes);
  bytes.add(std::uint64_t{1});
  add_text("", bytes);
  bytes.add(static_cast<std::uint32_t>(record.width));
  bytes.add(static_cast<std::uint32_t>(record.height));
  add_matrix(record.camera.intrinsics, bytes);
  add_matrix(Eigen::Matrix3d::Identity(), bytes);
  add_matrix(Vec3::Zero(), bytes);
  bytes.add(std::uint64_t{1});
  add_matrix(record.camera.rotation, bytes);
  add_matrix(record.camera.center(), bytes);
  return bytes.take();
}

std::string image_bytes(const CameraRecord& record, std::uint32_t platform) {
  LittleEndianWriter bytes;
  add_text(record.name, bytes);
  bytes.add(platform);
  bytes.add(std::uint32_t{0});  // camera
  bytes.add(std::uint32_t{0});  // pose
  return bytes.take();
}

}  // namespace

std::string write_openmvs(const CameraList& list) {
  std::vector<std::string> platforms, images;
  for (const CameraRecord& record : list.cameras) {
    check_sized_pinhole(record, "OpenMVS");
    images.push_back(image_bytes(record, static_cast<std::uint32_t>(platforms.size())));
    platforms.push_back(platform_bytes(record));
  }
  LittleEndianWriter bytes;
  bytes.add(std::string_view("MVSI"));
  // Version 2 of the interface, which all later versions of OpenMVS read.
  constexpr std::uint32_t version = 2;
  bytes.add(version);
  bytes.add(std::uint32_t{0});
  add_counted(platforms, bytes);
  add_counted(images, bytes);
  // The format has this number of further lists, for points and lines. They are written as empty.
  constexpr int lists_of_points_and_lines = 6;
  for (int i = 0; i < lists_of_points_and_lines; ++i) bytes.add(std::uint64_t{0});
  add_matrix(Eigen::Matrix4d::Identity(), bytes);
  return bytes.take();
}

}  // namespace transformesh
