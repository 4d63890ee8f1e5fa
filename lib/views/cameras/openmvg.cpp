// The sfm_data.json of OpenMVG, version 0.3. Reference: OpenMVG's manual, "SfM_data format".
#include <map>

#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_pose.h"
#include "views/cameras/json_entry.h"

namespace transformesh {
namespace {

JsonEntry data_of(const JsonEntry& entry) { return entry.at("value").at("ptr_wrapper").at("data"); }

/// Reads the distortion. The name of the list in the file determines its coefficients: radial ones,
/// followed by two tangential ones in `disto_t2`.
void read_openmvg_distortion(const JsonEntry& data, LensDistortion& distortion) {
  if (data.has("fisheye")) data.at("fisheye").fail("is not supported: undistort the images");
  if (data.has("disto_k1")) distortion.radial[0] = data.at("disto_k1").numbers(1)[0];
  if (data.has("disto_k3")) {
    const std::vector<double> k = data.at("disto_k3").numbers(3);
    distortion.radial = {k[0], k[1], k[2], 0, 0, 0};
  }
  if (data.has("disto_t2")) {
    const std::vector<double> k = data.at("disto_t2").numbers(5);
    distortion.radial = {k[0], k[1], k[2], 0, 0, 0};
    distortion.tangential = {k[3], k[4]};
  }
}

/// Reads the intrinsics. The principal point needs no shift: integer coordinates are pixel centers,
/// as in OpenMVG's features.
CameraRecord read_openmvg_lens(const JsonEntry& data) {
  CameraRecord record;
  // Lenses with distortion may have the parameters of the pinhole camera in a nested object.
  const JsonEntry pinhole = data.has("value0") ? data.at("value0") : data;
  record.width = pinhole.at("width").side();
  record.height = pinhole.at("height").side();
  if (!pinhole.has("focal_length")) pinhole.fail("is not a pinhole: it has no focal_length");
  const double focal = pinhole.at("focal_length").number();
  const std::vector<double> center = pinhole.at("principal_point").numbers(2);
  record.camera.intrinsics << focal, 0, center[0], 0, focal, center[1], 0, 0, 1;
  const std::string problem = intrinsics_problem(record.camera.intrinsics, "the lens");
  if (!problem.empty()) pinhole.fail(": " + problem);
  read_openmvg_distortion(data, record.distortion);
  return record;
}

void read_openmvg_pose(const JsonEntry& pose, PinholeCamera& camera) {
  Eigen::Matrix3d rotation;
  if (pose.at("rotation").elements().size() != 3) pose.at("rotation").fail("does not have 3 rows");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<double> row = pose.at("rotation").at(i).numbers(3);
    rotation.row(static_cast<Eigen::Index>(i)) << row[0], row[1], row[2];
  }
  const std::vector<double> center = pose.at("center").numbers(3);
  const std::string problem = set_pose_at(rotation, Vec3(center.data()), "the pose", camera);
  if (!problem.empty()) pose.fail(": " + problem);
}

std::string image_name_of(const JsonEntry& view) {
  const std::string folder = view.text("local_path", "");
  const std::string name = view.at("filename").text();
  return folder.empty() ? name : folder + (folder.ends_with('/') ? "" : "/") + name;
}

}  // namespace

CameraList read_openmvg(const Source& source) {
  const nlohmann::json json = parse_camera_json(source);
  const JsonEntry file(json, source);
  std::map<std::string, JsonEntry> lenses;
  std::map<std::string, JsonEntry> poses;
  for (const JsonEntry& entry : file.at("intrinsics").elements())
    lenses.emplace(entry.at("key").text(), data_of(entry));
  for (const JsonEntry& entry : file.at("extrinsics").elements())
    poses.emplace(entry.at("key").text(), entry.at("value"));
  CameraList list;
  list.names_images = true;
  for (const JsonEntry& entry : file.at("views").elements()) {
    const JsonEntry view = data_of(entry);
    // Views whose pose OpenMVG could not determine have no entry in `poses`.
    const auto pose = poses.find(view.at("id_pose").text());
    if (pose == poses.end()) continue;
    const auto lens = lenses.find(view.at("id_intrinsic").text());
    if (lens == lenses.end()) view.at("id_intrinsic").fail("does not match any intrinsic");
    CameraRecord record = read_openmvg_lens(lens->second);
    record.name = image_name_of(view);
    record.place = view.place();
    read_openmvg_pose(pose->second, record.camera);
    list.cameras.push_back(std::move(record));
  }
  if (list.cameras.empty()) source.fail("no view of the OpenMVG file has a pose");
  return list;
}

}  // namespace transformesh
