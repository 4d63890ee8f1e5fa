#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "io/formats/xml_elements.h"
#include "support/elementary/trigonometric.h"
#include "support/number.h"
#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

/// Width of 35 mm film; the focal lengths in these files are for this width.
constexpr double film_width_mm = 36;

/// Lens parameters that a table row or an XMP file contains. Lengths are fractions of the image's
/// larger side, except for `focal_mm`.
struct RealityCaptureLens {
  double focal_mm = 0;
  double aspect = 1;
  double skew = 0;
  double u = 0, v = 0;  ///< principal point relative to the image's center
  std::array<double, 4> k{};
  std::array<double, 2> t{};
};

/// Returns a record with intrinsics but without pose. The distortion is Brown's model with OpenCV's
/// coefficients, except for k4, the factor of r^8, which must be 0.
CameraRecord record_of(const RealityCaptureLens& lens, const std::string& who,
                       const Source& source) {
  CameraRecord record;
  record.place = source.name;
  const double focal = lens.focal_mm / film_width_mm;
  record.camera.intrinsics << focal, lens.skew, lens.u, 0, focal * lens.aspect, lens.v, 0, 0, 1;
  const std::string problem = intrinsics_problem(record.camera.intrinsics, who);
  if (!problem.empty()) source.fail(problem);
  if (lens.k[3] != 0)
    source.fail("k4 of " + who +
                " is not supported: export with another model of distortion, "
                "such as Brown3, or undistorted images");
  record.distortion.radial = {lens.k[0], lens.k[1], lens.k[2], 0, 0, 0};
  record.distortion.tangential = lens.t;
  record.unit = IntrinsicsUnit::larger_side;
  record.is_centered = true;
  return record;
}

void place_at(const Vec3& center, const std::string& who, const Source& source,
              PinholeCamera& camera) {
  camera.translation = -camera.rotation * center;
  const std::string problem = translation_problem(camera.translation, who);
  if (!problem.empty()) source.fail(problem);
}

Eigen::Matrix3d turned(double angle_deg, int axis) {
  const double angle = angle_deg * std::numbers::pi / 180;
  const double c = elementary::cos(angle);
  const double s = elementary::sin(angle);
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(next, next) = rotation(last, last) = c;
  rotation(next, last) = -s;
  rotation(last, next) = s;
  return rotation;
}

/// Returns the rotation from the world to the camera. If all angles are 0, the camera looks down
/// along -z, and north (y) is up in the image. Heading rotates the camera clockwise about the
/// vertical axis. Then pitch and roll rotate it about its own x and y axes.
Eigen::Matrix3d rotation_of_angles(double heading, double pitch, double roll) {
  const Eigen::Matrix3d to_world = turned(-heading, 2) * turned(pitch, 0) * turned(roll, 1);
  return Vec3(1, -1, -1).asDiagonal() * to_world.transpose();
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
  for (;;) {
    const std::size_t comma = std::min(line.find(','), line.size());
    fields.emplace_back(line.substr(0, comma));
    if (comma == line.size()) return fields;
    line.remove_prefix(comma + 1);
  }
}

/// A row of a CSV table, whose fields are accessed by the names of columns.
class Row {
 public:
  Row(const std::vector<std::string>& columns, const std::vector<std::string>& fields,
      const Source& source, const char* place)
      : source_(source), place_(place) {
    if (fields.size() != columns.size())
      source.fail_at_line(place, "a row has " + std::to_string(fields.size()) + " fields, not " +
                                     std::to_string(columns.size()));
    for (std::size_t i = 0; i < fields.size(); ++i) fields_[columns[i]] = fields[i];
  }

  const std::string& text(const std::string& column) const {
    const auto field = fields_.find(column);
    if (field == fields_.end())
      source_.fail_at_line(place_, "the RealityCapture table has no column " + column);
    return field->second;
  }
  double number(const std::string& column) const {
    const auto value = number_in<double>(text(column));
    if (value && std::isfinite(*value)) return *value;
    source_.fail_at_line(
        place_, column + " is " + in_quotes(text(column)) + ", which is not a finite number");
  }
  /// Returns the number in a column, or 0 if there is no such column.
  double optional_number(const std::string& column) const {
    return fields_.contains(column) ? number(column) : 0;
  }

 private:
  const Source& source_;
  const char* place_;
  std::map<std::string, std::string> fields_;
};

CameraRecord read_table_row(const Row& row, const Source& source, const char* place) {
  const std::string name = row.text("#name");
  const std::string who = "camera " + in_quotes(name);
  RealityCaptureLens lens;
  lens.focal_mm = row.number("f");
  lens.u = row.number("px");
  lens.v = row.number("py");
  lens.k = {row.optional_number("k1"), row.optional_number("k2"), row.optional_number("k3"),
            row.optional_number("k4")};
  lens.t = {row.optional_number("t1"), row.optional_number("t2")};
  CameraRecord record = record_of(lens, who, source);
  record.name = name;
  record.place = source.name + " line " + std::to_string(source.line_of(place));
  record.camera.rotation =
      rotation_of_angles(row.number("heading"), row.number("pitch"), row.number("roll"));
  place_at({row.number("x"), row.number("y"), row.number("alt")}, who, source, record.camera);
  return record;
}

CameraList read_table(const Source& source) {
  CameraList list;
  list.names_images = true;
  std::vector<std::string> columns;
  const char* place = source.begin();
  while (place != source.end()) {
    const char* const end = std::find(place, source.end(), '\n');
    const std::string_view line(place, static_cast<std::size_t>(end - place));
    if (line.starts_with("#name")) {
      columns = fields_of(line);
    } else if (!line.starts_with('#') && line.find_first_not_of(" \r") != std::string_view::npos) {
      const Row row(columns, fields_of(line), source, place);
      list.cameras.push_back(read_table_row(row, source, place));
    }
    place = end == source.end() ? end : end + 1;
  }
  if (list.cameras.empty()) source.fail("there is no camera in the RealityCapture table");
  return list;
}

/// Returns the numbers of the attribute `name` of `description` or, if there is none, of its child
/// element `name`.
std::vector<double> values(const pugi::xml_node& description, const std::string& name,
                           const Source& source) {
  if (const auto attribute = xml_attribute(description, name.c_str()))
    return xml_numbers(*attribute, name, source);
  const pugi::xml_node element = xml_element(description, name.c_str());
  return element ? xml_numbers(element.child_value(), name, source) : std::vector<double>();
}

double value(const pugi::xml_node& description, const std::string& name, double otherwise,
             const Source& source) {
  const auto numbers = values(description, name, source);
  return numbers.empty() ? otherwise : numbers.front();
}

RealityCaptureLens lens_from_description(const pugi::xml_node& description, const Source& source) {
  RealityCaptureLens lens;
  lens.focal_mm = value(description, "xcr:FocalLength35mm", 0, source);
  lens.aspect = value(description, "xcr:AspectRatio", 1, source);
  lens.skew = value(description, "xcr:Skew", 0, source);
  lens.u = value(description, "xcr:PrincipalPointU", 0, source);
  lens.v = value(description, "xcr:PrincipalPointV", 0, source);
  std::vector<double> k = values(description, "xcr:DistortionCoeficients", source);
  k.resize(6, 0);
  const std::string model =
      xml_attribute(description, "xcr:DistortionModel").value_or("perspective");
  const bool is_plain = k == std::vector<double>(6, 0);
  if (!is_plain && !model.starts_with("brown"))
    source.fail("the distortion model " + in_quotes(model) +
                " is not supported: export with Brown3, or undistorted images");
  lens.k = {k[0], k[1], k[2], k[3]};
  lens.t = {k[4], k[5]};
  return lens;
}

}  // namespace

CameraList read_reality_capture(const Source& source, const std::string& stem) {
  if (source.bytes.find("xcr:") == std::string_view::npos) return read_table(source);
  const pugi::xml_document document = parse_xml(source);
  const pugi::xml_node description = xml_element(document, "rdf:Description");
  if (!description) source.fail("the RealityCapture XMP file has no rdf:Description");
  CameraRecord record = record_of(lens_from_description(description, source), "the camera", source);
  const auto rotation = values(description, "xcr:Rotation", source);
  const auto center = values(description, "xcr:Position", source);
  if (rotation.size() != 9 || center.size() != 3)
    source.fail(
        "the RealityCapture XMP file has no xcr:Rotation of 9 numbers and xcr:Position of 3");
  Eigen::Matrix3d& r = record.camera.rotation;
  for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = rotation[static_cast<std::size_t>(i)];
  if (!(r * r.transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-3) || r.determinant() < 0)
    source.fail("xcr:Rotation is not a rotation");
  place_at(Vec3(center.data()), "the camera", source, record.camera);
  record.name = stem;
  CameraList list;
  list.names_images = true;
  list.cameras.push_back(std::move(record));
  return list;
}

}  // namespace transformesh
