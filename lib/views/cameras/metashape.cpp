#include <Eigen/LU>
#include <map>

#include "io/formats/xml_elements.h"
#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

/// Lens parameters that several cameras of a file share.
struct Sensor {
  Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();
  LensDistortion distortion;
  int width = 0;
  int height = 0;
  bool is_calibrated = false;
};

double number(const pugi::xml_node& calibration, const char* name, const Source& source) {
  const auto element = xml_element(calibration, name);
  if (!element) return 0;
  const auto numbers = xml_numbers(element.child_value(), name, source);
  if (numbers.size() != 1) source.fail(std::string(name) + " of a sensor is not one number");
  return numbers.front();
}

int resolution_side(const pugi::xml_node& resolution, const char* name, const Source& source) {
  const auto text = xml_attribute(resolution, name);
  const auto numbers = xml_numbers(text.value_or(""), name, source);
  if (numbers.size() != 1 || !(numbers[0] >= 1 && numbers[0] <= 1e9))
    source.fail("the resolution of a sensor has no " + std::string(name));
  return static_cast<int>(numbers[0]);
}

/// Returns the calibration of a sensor. If the file has an initial and an adjusted one, returns the
/// adjusted one.
pugi::xml_node calibration_of(const pugi::xml_node& sensor) {
  pugi::xml_node found;
  for (const pugi::xml_node& calibration : xml_elements(sensor, "calibration"))
    if (!found || xml_attribute(calibration, "class") == "adjusted") found = calibration;
  return found;
}

/// Reads a sensor with the camera model "frame" of Metashape's manual. The model's p1 and p2 are
/// OpenCV's p2 and p1. The principal point is relative to the image's center.
Sensor read_sensor(const pugi::xml_node& element, const Source& source) {
  Sensor sensor;
  const auto calibration = calibration_of(element);
  if (!calibration) return sensor;
  if (const auto type = xml_attribute(calibration, "type"); type && *type != "frame")
    source.fail("a sensor is of the type " + in_quotes(*type) +
                ", not 'frame': undistort its photographs");
  pugi::xml_node resolution = xml_element(calibration, "resolution");
  if (!resolution) resolution = xml_element(element, "resolution");
  if (!resolution) source.fail("a sensor has no resolution");
  sensor.width = resolution_side(resolution, "width", source);
  sensor.height = resolution_side(resolution, "height", source);
  const auto get = [&](const char* name) { return number(calibration, name, source); };
  const double f = get("f");
  sensor.intrinsics << f + get("b1"), get("b2"), (sensor.width - 1) / 2.0 + get("cx"),  //
      0, f, (sensor.height - 1) / 2.0 + get("cy"), 0, 0, 1;
  const std::string problem = intrinsics_problem(sensor.intrinsics, "a sensor");
  if (!problem.empty()) source.fail(problem);
  sensor.distortion.radial = {get("k1"), get("k2"), get("k3"), 0, 0, 0};
  sensor.distortion.tangential = {get("p2"), get("p1")};
  for (const char* name : {"k4", "p3", "p4"})
    if (get(name) != 0)
      source.fail(std::string(name) + " of a sensor is not supported: undistort the images");
  sensor.is_calibrated = true;
  return sensor;
}

/// Converts the transform of a camera to a pose. The transform maps camera coordinates to the
/// coordinates of a chunk, which is one reconstruction in a Metashape file.
PinholeCamera pose_of(const std::vector<double>& numbers, const std::string& who,
                      const Source& source) {
  if (numbers.size() != 16) source.fail("the transform of " + who + " does not have 16 numbers");
  PinholeCamera pose;
  Vec3 center;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) pose.rotation(j, i) = numbers[static_cast<std::size_t>(4 * i + j)];
    center[i] = numbers[static_cast<std::size_t>(4 * i + 3)];
  }
  const Eigen::Matrix3d product = pose.rotation * pose.rotation.transpose();
  if (!product.isApprox(Eigen::Matrix3d::Identity(), 1e-3) || pose.rotation.determinant() < 0)
    source.fail("the transform of " + who + " has no rotation");
  pose.translation = -pose.rotation * center;
  const std::string problem = translation_problem(pose.translation, who);
  if (!problem.empty()) source.fail(problem);
  return pose;
}

CameraRecord read_metashape_camera(const pugi::xml_node& element, const pugi::xml_node& transform,
                                   const std::map<std::string, Sensor>& sensors,
                                   const Source& source) {
  CameraRecord record;
  record.name = xml_attribute(element, "label").value_or("");
  record.place = source.name;
  const std::string who = "camera " + in_quotes(record.name);
  const auto sensor = sensors.find(xml_attribute(element, "sensor_id").value_or(""));
  if (sensor == sensors.end()) source.fail("there is no sensor of " + who);
  if (!sensor->second.is_calibrated) source.fail("the sensor of " + who + " has no calibration");
  const auto numbers = xml_numbers(transform.child_value(), "the transform of " + who, source);
  record.camera = pose_of(numbers, who, source);
  record.camera.intrinsics = sensor->second.intrinsics;
  record.distortion = sensor->second.distortion;
  record.width = sensor->second.width;
  record.height = sensor->second.height;
  return record;
}

}  // namespace

CameraList read_metashape(const Source& source) {
  const pugi::xml_document document = parse_xml(source);
  const auto chunks = xml_elements(document, "chunk");
  if (chunks.size() != 1)
    source.fail(chunks.empty() ? "the Metashape file has no chunk"
                               : "the Metashape file has several chunks: export only one");
  std::map<std::string, Sensor> sensors;
  for (const pugi::xml_node& element : xml_elements(chunks[0], "sensor"))
    sensors[xml_attribute(element, "id").value_or("")] = read_sensor(element, source);
  CameraList list;
  list.names_images = true;
  for (const pugi::xml_node& element : xml_elements(chunks[0], "camera")) {
    // Skip cameras without a transform: Metashape could not determine their pose.
    if (const auto transform = xml_element(element, "transform"))
      list.cameras.push_back(read_metashape_camera(element, transform, sensors, source));
  }
  if (list.cameras.empty()) source.fail("no camera of the Metashape file is aligned");
  return list;
}

}  // namespace transformesh
