#include "options/camera_table.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "frame/report.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/pinhole_camera.h"

namespace transformesh::tool {
namespace {

using Row = std::vector<std::string>;

// Adding 0.0 turns -0 into 0, so that the table does not show negative zeros.
std::string rounded(double value, int digits) { return significant(value + 0.0, digits); }

// Returns the size of a pixel at the scene's center. Returns nothing if the center is behind the
// camera.
std::optional<double> pixel_size_of(const PinholeCamera& camera, const Vec3& center) {
  const bool is_in_front = (camera.rotation * center + camera.translation).z() > 0;
  return is_in_front ? std::optional(pixel_size({&camera, 1}, center)) : std::nullopt;
}

std::string size_text(const CameraRecord& record) {
  if (record.width == 0) return "-";
  return std::to_string(record.width) + 'x' + std::to_string(record.height);
}

std::string pairs_text(const CameraTable& table, std::size_t camera) {
  std::string text;
  for (const ViewPair& pair : table.pairs) {
    if (pair.first != camera) continue;
    text += (text.empty() ? "" : " ") + table.list.cameras[pair.second].name + ':' +
            rounded(pair.angle_deg, 4);
  }
  return text.empty() ? "-" : text;
}

Row row_of(const CameraTable& table, std::size_t i) {
  constexpr int digits = 6;
  const CameraRecord& record = table.list.cameras[i];
  const Vec3 center = record.camera.center();
  const auto size = pixel_size_of(record.camera, table.scene_center);
  return {record.name,
          size_text(record),
          rounded(record.camera.focal_length(), digits),
          rounded(center.x(), digits),
          rounded(center.y(), digits),
          rounded(center.z(), digits),
          size ? rounded(*size, digits) : "-",
          pairs_text(table, i)};
}

std::string aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      text += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    }
    text += row.back() + '\n';
  }
  return text;
}

nlohmann::ordered_json json_of(const Vec3& point) {
  return {point.x() + 0.0, point.y() + 0.0, point.z() + 0.0};
}

nlohmann::ordered_json number_or_null(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json json_of(const CameraTable& table, std::size_t camera) {
  const CameraRecord& record = table.list.cameras[camera];
  const auto size = pixel_size_of(record.camera, table.scene_center);
  nlohmann::ordered_json json;
  json["name"] = record.name;
  json["width"] = record.width;
  json["height"] = record.height;
  json["focal_length"] = record.camera.focal_length();
  json["center"] = json_of(record.camera.center());
  json["pixel_size"] = number_or_null(size);
  json["pairs"] = nlohmann::ordered_json::array();
  for (const ViewPair& pair : table.pairs) {
    if (pair.first != camera) continue;
    json["pairs"].push_back(
        {{"name", table.list.cameras[pair.second].name}, {"angle", pair.angle_deg}});
  }
  return json;
}

}  // namespace

std::string text_of(const CameraTable& table) {
  std::vector<Row> rows{{"name", "size", "focal", "x", "y", "z", "pixel", "pairs"}};
  for (std::size_t i = 0; i < table.list.cameras.size(); ++i) rows.push_back(row_of(table, i));
  return aligned(rows);
}

std::string json_of(const CameraTable& table) {
  nlohmann::ordered_json json;
  json["scene_center"] = json_of(table.scene_center);
  json["pixel_size"] = number_or_null(table.pixel_size);
  json["cameras"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < table.list.cameras.size(); ++i) {
    json["cameras"].push_back(json_of(table, i));
  }
  return json_text(json);
}

CameraTable table_of(CameraList list, const std::vector<double>& center, std::size_t neighbors) {
  std::vector<PinholeCamera> cameras;
  for (const CameraRecord& record : list.cameras) {
    if (record.unit != IntrinsicsUnit::pixel)
      throw InputError("the focal length of '" + record.name +
                       "' is given as a fraction of the image's side (" + record.place +
                       "): name the images");
    cameras.push_back(record.camera);
  }
  CameraTable table;
  table.list = std::move(list);
  table.is_center_assumed = center.empty() && cameras.size() == 1;
  if (!center.empty())
    table.scene_center = Vec3(center.data());
  else if (table.is_center_assumed)
    table.scene_center = cameras[0].center() + cameras[0].rotation.row(2).normalized().transpose();
  else
    table.scene_center = viewed_point(cameras);
  const bool is_seen = std::any_of(cameras.begin(), cameras.end(), [&](const auto& camera) {
    return pixel_size_of(camera, table.scene_center).has_value();
  });
  if (is_seen) table.pixel_size = pixel_size(cameras, table.scene_center);
  PairOptions pairs;
  pairs.neighbors = neighbors;
  table.pairs = choose_pairs(cameras, table.scene_center, pairs);
  return table;
}

}  // namespace transformesh::tool
