// The transforms.json of NeRF, instant-ngp and nerfstudio. References: Mildenhall, Srinivasan,
// Tancik, Barron, Ramamoorthi & Ng, "NeRF: representing scenes as neural radiance fields for view
// synthesis", ECCV 2020; nerfstudio's manual, "Data conventions".
#include <array>
#include <cmath>

#include "support/elementary/trigonometric.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_pose.h"
#include "views/cameras/json_entry.h"

namespace transformesh {
namespace {

/// A frame (image) of the file. Keys that are missing in the frame are read from the top level of
/// the file.
struct Frame {
  JsonEntry entry;
  JsonEntry file;

  bool has(const char* key) const { return entry.has(key) || file.has(key); }
  JsonEntry at(const char* key) const { return entry.has(key) ? entry.at(key) : file.at(key); }
  double number(const char* key) const { return has(key) ? at(key).number() : 0; }
};

void check_model(const Frame& frame) {
  if (frame.has("camera_model")) {
    const std::string model = frame.at("camera_model").text();
    for (const char* known :
         {"OPENCV", "PINHOLE", "SIMPLE_PINHOLE", "PERSPECTIVE", "SIMPLE_RADIAL", "RADIAL"})
      if (model == known) return;
    frame.at("camera_model").fail(in_quotes(model) + " is not supported: undistort the images");
  }
  if (frame.has("is_fisheye") && frame.at("is_fisheye").is_true())
    frame.at("is_fisheye").fail("is true: undistort the images");
}

/// Returns the focal length that follows from the field of view, in pixels. If `side` is 0, the
/// size of the image is unknown, and the unit is the side of the image.
double focal_of(const Frame& frame, const char* angle_key, int side) {
  const double angle = frame.at(angle_key).number();
  if (!(angle > 0 && angle < 3.14159)) frame.at(angle_key).fail("is not between 0 and pi");
  return (side > 0 ? side : 1) / (2 * elementary::tan(angle / 2));
}

void read_focals(const Frame& frame, CameraRecord& record) {
  double& x = record.camera.intrinsics(0, 0);
  double& y = record.camera.intrinsics(1, 1);
  if (frame.has("fl_x") || frame.has("fl_y")) {
    x = frame.at(frame.has("fl_x") ? "fl_x" : "fl_y").number();
    y = frame.has("fl_y") ? frame.number("fl_y") : x;
    return;
  }
  if (!frame.has("camera_angle_x")) frame.entry.fail("has neither fl_x nor camera_angle_x");
  if (record.width == 0) record.unit = IntrinsicsUnit::width;
  x = y = focal_of(frame, "camera_angle_x", record.width);
  if (record.height > 0 && frame.has("camera_angle_y"))
    y = focal_of(frame, "camera_angle_y", record.height);
}

void read_principal_point(const Frame& frame, CameraRecord& record) {
  auto center = record.camera.intrinsics.col(2);
  if (frame.has("cx") && frame.has("cy")) {
    if (record.unit != IntrinsicsUnit::pixel)
      frame.entry.fail("has cx, but not the image's w and h");
    center.head<2>() << frame.number("cx") - pixel_center, frame.number("cy") - pixel_center;
  } else if (record.width > 0) {
    center.head<2>() << (record.width - 1) / 2.0, (record.height - 1) / 2.0;
  } else {
    record.is_centered = true;
  }
}

void read_frame_lens(const Frame& frame, CameraRecord& record) {
  check_model(frame);
  if (frame.has("w") && frame.has("h")) {
    record.width = frame.at("w").side();
    record.height = frame.at("h").side();
  }
  read_focals(frame, record);
  read_principal_point(frame, record);
  const std::string problem = intrinsics_problem(record.camera.intrinsics, "the frame");
  if (!problem.empty()) frame.entry.fail(": " + problem);
  record.distortion.radial = {frame.number("k1"), frame.number("k2"), frame.number("k3"), 0, 0, 0};
  record.distortion.tangential = {frame.number("p1"), frame.number("p2")};
  if (frame.number("k4") != 0) frame.at("k4").fail("is not supported: undistort the images");
}

/// Reads the matrix that maps camera coordinates to world coordinates. In camera coordinates, x
/// points to the right, y up and z backwards.
void read_frame_pose(const JsonEntry& matrix, CameraRecord& record) {
  Eigen::Matrix3d to_world;
  Vec3 center;
  const std::size_t rows = matrix.elements().size();
  if (rows != 3 && rows != 4) matrix.fail("does not have 3 or 4 rows");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<double> row = matrix.at(i).numbers(4);
    to_world.row(static_cast<Eigen::Index>(i)) << row[0], -row[1], -row[2];
    center[static_cast<Eigen::Index>(i)] = row[3];
  }
  if (rows == 4 && matrix.at(3).numbers(4) != std::vector<double>{0, 0, 0, 1})
    matrix.fail("does not end with the row 0 0 0 1");
  const std::string problem = set_pose_at(to_world.transpose(), center, "the frame", record.camera);
  if (!problem.empty()) matrix.fail(": " + problem);
}

}  // namespace

CameraList read_transforms(const Source& source) {
  const nlohmann::json json = parse_camera_json(source);
  const JsonEntry file(json, source);
  CameraList list;
  list.names_images = true;
  for (const JsonEntry& entry : file.at("frames").elements()) {
    CameraRecord record;
    record.name = entry.at("file_path").text();
    if (record.name.starts_with("./")) record.name.erase(0, 2);
    record.place = entry.place();
    read_frame_lens({entry, file}, record);
    read_frame_pose(entry.at("transform_matrix"), record);
    list.cameras.push_back(std::move(record));
  }
  if (list.cameras.empty()) source.fail("there is no frame in the file");
  return list;
}

}  // namespace transformesh
