#include <algorithm>

#include "support/number.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/json_entry.h"

namespace transformesh {
namespace {

/// Meshroom writes all numbers as text.
OrderedJson text_of(double value) { return shortest_text(value); }

/// Returns the coefficients of a matrix as a list of texts, column by column.
template <class Matrix>
OrderedJson texts_of(const Matrix& matrix) {
  OrderedJson list = OrderedJson::array();
  for (Eigen::Index i = 0; i < matrix.size(); ++i) list.push_back(text_of(matrix(i)));
  return list;
}

void check_for_meshroom(const CameraRecord& record) {
  check_sized_pinhole(record, "Meshroom");
  const auto& k = record.distortion.radial;
  if (k[3] == 0 && k[4] == 0 && k[5] == 0) return;
  throw InputError("Meshroom has no distortion k4, k5 and k6, but the lens of " +
                   in_quotes(record.name) + " has (" + record.place + ")");
}

OrderedJson intrinsics_json(const CameraRecord& record, const std::string& id) {
  const Eigen::Matrix3d& k = record.camera.intrinsics;
  const auto& radial = record.distortion.radial;
  const auto& [p1, p2] = record.distortion.tangential;
  const bool is_brown = p1 != 0 || p2 != 0;
  OrderedJson distortion = OrderedJson::array();
  if (!record.distortion.is_none())
    for (std::size_t i = 0; i < 3; ++i) distortion.push_back(text_of(radial[i]));
  if (is_brown) {
    distortion.push_back(text_of(p1));
    distortion.push_back(text_of(p2));
  }
  return {{"intrinsicId", id},
          {"width", std::to_string(record.width)},
          {"height", std::to_string(record.height)},
          {"serialNumber", ""},
          {"type", is_brown                      ? "brown"
                   : record.distortion.is_none() ? "pinhole"
                                                 : "radial3"},
          {"initializationMode", "calibrated"},
          {"pxInitialFocalLength", "-1"},
          {"pxFocalLength", {text_of(k(0, 0)), text_of(k(1, 1))}},
          {"principalPoint", {text_of(k(0, 2)), text_of(k(1, 2))}},
          {"distortionParams", distortion},
          {"locked", "0"}};
}

OrderedJson view_json(const CameraRecord& record, const std::string& id, const std::string& lens) {
  return {{"viewId", id},
          {"poseId", id},
          {"intrinsicId", lens},
          {"path", record.name},
          {"width", std::to_string(record.width)},
          {"height", std::to_string(record.height)},
          {"metadata", ""}};
}

OrderedJson pose_json(const PinholeCamera& camera, const std::string& id) {
  const OrderedJson transform{{"rotation", texts_of(camera.rotation)},
                              {"center", texts_of(camera.center())}};
  return {{"poseId", id}, {"pose", {{"transform", transform}, {"locked", "0"}}}};
}

std::string member(const char* key, const std::vector<std::string>& values) {
  std::string text = "  \"" + std::string(key) + "\": [";
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i > 0 ? ",\n    " : "\n    ") + values[i];
  return text + "\n  ]";
}

}  // namespace

std::string write_meshroom(const CameraList& list) {
  std::vector<std::string> views, lenses, poses;
  for (std::size_t i = 0; i < list.cameras.size(); ++i) {
    const CameraRecord& record = list.cameras[i];
    check_for_meshroom(record);
    const std::string id = std::to_string(i);
    const std::size_t lens = lens_of(list, record);
    views.push_back(json_text(view_json(record, id, std::to_string(lens)), record));
    if (lens == i) lenses.push_back(intrinsics_json(record, id).dump());
    poses.push_back(pose_json(record.camera, id).dump());
  }
  // The newest version of the format whose intrinsics are in pixels.
  const OrderedJson version{"1", "2", "0"};
  return "{\n  \"version\": " + version.dump() + ",\n" + member("views", views) + ",\n" +
         member("intrinsics", lenses) + ",\n" + member("poses", poses) + "\n}\n";
}

}  // namespace transformesh
