// The files NAME_cam.txt of MVSNet and of programs that follow it. Reference: Yao, Luo, Li, Fang &
// Quan, "MVSNet: depth inference for unstructured multi-view stereo", ECCV 2018, and the manual of
// its program, "File formats".
#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_pose.h"

namespace transformesh {
namespace {

void read_section_title(TextRows& rows, std::string_view title) {
  if (!rows.next_row() || rows.peek() != title)
    rows.fail("the line '" + std::string(title) + "' is missing");
  rows.word();
  rows.end_row([&] { return "the line " + std::string(title); });
}

Eigen::MatrixXd read_square_matrix(TextRows& rows, int size, const std::string& what) {
  Eigen::MatrixXd matrix(size, size);
  for (int i = 0; i < size; ++i) {
    const std::string row = "row " + std::to_string(i + 1) + " of " + what;
    if (!rows.next_row()) rows.fail(row + " is missing");
    for (int j = 0; j < size; ++j)
      matrix(i, j) = rows.finite_number<double>(
          [&] { return "number " + std::to_string(j + 1) + " of " + row; });
    rows.end_row([&] { return row; });
  }
  return matrix;
}

}  // namespace

CameraList read_mvsnet(const Source& source, const std::string& stem) {
  TextRows rows(source, 0, {'\0', false});
  CameraRecord record;
  record.name = stem;
  record.place = source.name;
  read_section_title(rows, "extrinsic");
  const Eigen::MatrixXd pose = read_square_matrix(rows, 4, "extrinsic");
  if (pose.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    rows.fail("extrinsic does not end with the row 0 0 0 1");
  std::string problem =
      set_pose(pose.topLeftCorner<3, 3>(), pose.topRightCorner<3, 1>(), "extrinsic", record.camera);
  if (!problem.empty()) rows.fail(problem);
  read_section_title(rows, "intrinsic");
  Eigen::Matrix3d k = read_square_matrix(rows, 3, "intrinsic");
  // Files of this format are converted from COLMAP's, with the same principal point.
  k.col(2).head<2>().array() -= pixel_center;
  problem = intrinsics_problem(k, "intrinsic");
  if (!problem.empty()) rows.fail(problem);
  record.camera.intrinsics = k;
  CameraList list;
  list.cameras.push_back(std::move(record));
  return list;
}

}  // namespace transformesh
