#include <algorithm>

#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/json_entry.h"

namespace transformesh {
namespace {

void check_for_transforms(const CameraRecord& record) {
  check_sized_pinhole(record, "transforms.json");
  const auto& k = record.distortion.radial;
  if (k[3] == 0 && k[4] == 0 && k[5] == 0) return;
  throw InputError("transforms.json has no distortion k4, k5 and k6, but the lens of " +
                   in_quotes(record.name) + " has (" + record.place + ")");
}

OrderedJson lens_json(const CameraRecord& record) {
  const Eigen::Matrix3d& k = record.camera.intrinsics;
  const LensDistortion& lens = record.distortion;
  OrderedJson json{{"camera_model", "OPENCV"},
                   {"w", record.width},
                   {"h", record.height},
                   {"fl_x", k(0, 0)},
                   {"fl_y", k(1, 1)},
                   {"cx", k(0, 2) + pixel_center},
                   {"cy", k(1, 2) + pixel_center}};
  if (lens.is_none()) return json;
  json["k1"] = lens.radial[0];
  json["k2"] = lens.radial[1];
  json["k3"] = lens.radial[2];
  json["p1"] = lens.tangential[0];
  json["p2"] = lens.tangential[1];
  return json;
}

/// Returns the matrix that maps camera coordinates, with y up and z backwards, to world
/// coordinates.
OrderedJson matrix_of(const PinholeCamera& camera) {
  const Eigen::Matrix3d to_world = camera.rotation.transpose();
  const Vec3 center = camera.center();
  OrderedJson rows = OrderedJson::array();
  for (int i = 0; i < 3; ++i)
    rows.push_back({to_world(i, 0), -to_world(i, 1), -to_world(i, 2), center[i]});
  rows.push_back({0, 0, 0, 1});
  return rows;
}

OrderedJson frame_of(const CameraRecord& record, bool has_own_lens) {
  OrderedJson frame{{"file_path", record.name}};
  if (has_own_lens) frame.update(lens_json(record));
  frame["transform_matrix"] = matrix_of(record.camera);
  return frame;
}

}  // namespace

std::string write_transforms(const CameraList& list) {
  for (const CameraRecord& record : list.cameras) check_for_transforms(record);
  const bool is_shared =
      std::all_of(list.cameras.begin(), list.cameras.end(),
                  [&](const CameraRecord& record) { return lens_of(list, record) == 0; });
  std::string text = "{\n";
  const OrderedJson shared = is_shared ? lens_json(list.cameras.front()) : OrderedJson::object();
  for (const auto& [key, value] : shared.items())
    text += "  \"" + key + "\": " + value.dump() + ",\n";
  text += "  \"frames\": [";
  for (std::size_t i = 0; i < list.cameras.size(); ++i)
    text += (i > 0 ? ",\n    " : "\n    ") +
            json_text(frame_of(list.cameras[i], !is_shared), list.cameras[i]);
  return text + "\n  ]\n}\n";
}

}  // namespace transformesh
