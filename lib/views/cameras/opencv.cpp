#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <initializer_list>
#include <optional>

#include "support/elementary/trigonometric.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

using Entries = std::vector<double>;
using Keys = std::initializer_list<const char*>;

constexpr std::string_view blanks = " \t\r\n";

/// Entries of a file that OpenCV's FileStorage wrote as YAML or XML.
class Storage {
 public:
  explicit Storage(const Source& source)
      : source_(source), is_xml_(source.bytes.find("<opencv_storage") != std::string_view::npos) {}

  /// Returns the numbers of the first key that exists, or nothing if none exists.
  std::optional<Entries> find(Keys keys) const {
    for (const char* key : keys)
      if (const auto text = text_of(key)) return numbers_in(*text, key);
    return {};
  }

  Entries get(Keys keys) const {
    if (auto entries = find(keys)) return *entries;
    source_.fail("OpenCV's file has no " + std::string(*keys.begin()));
  }

  int side(const char* key) const {
    const auto entries = find({key});
    return entries && entries->size() == 1 && entries->front() >= 1 && entries->front() <= 1e9
               ? static_cast<int>(entries->front())
               : 0;
  }

  [[noreturn]] void fail(const std::string& what) const { source_.fail(what); }

 private:
  /// Returns the position of the value of the key, or npos if there is no such key.
  std::size_t value_of(const std::string& key) const {
    const std::string_view text = source_.bytes;
    const std::string start = is_xml_ ? "<" + key : key + ":";
    for (std::size_t at = text.find(start); at != std::string_view::npos;
         at = text.find(start, at + 1)) {
      const std::size_t end = at + start.size();
      const bool is_whole = is_xml_ ? end < text.size() && (text[end] == '>' || text[end] == ' ')
                                    : at == 0 || blanks.find(text[at - 1]) < blanks.size();
      if (is_whole) return is_xml_ ? text.find('>', end) + 1 : end;
    }
    return std::string_view::npos;
  }

  std::optional<std::string_view> text_of(const std::string& key) const {
    const std::size_t value = value_of(key);
    if (value == std::string_view::npos) return {};
    std::string_view rest = source_.bytes.substr(std::min(value, source_.bytes.size()));
    if (is_xml_) {
      rest = rest.substr(0, rest.find("</" + key));
      const std::size_t data = rest.find("<data>");
      return data == std::string_view::npos ? rest
                                            : rest.substr(data + 6, rest.find("</data") - data - 6);
    }
    const std::size_t first = std::min(rest.find_first_not_of(" \t"), rest.size());
    const std::string_view line = rest.substr(first, rest.find_first_of("\r\n", first) - first);
    if (!line.starts_with('!') && !line.empty() && !line.starts_with('[')) return line;
    const std::size_t open = rest.find('[');
    const std::size_t close = rest.find(']');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      return {};
    return rest.substr(open + 1, close - open - 1);
  }

  Entries numbers_in(std::string_view text, const std::string& key) const {
    const std::string separators = std::string(blanks) + ',';
    Entries entries;
    for (;;) {
      text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
      if (text.empty()) return entries;
      const std::string_view word = text.substr(0, text.find_first_of(separators));
      const char* first = word.data();
      double value = 0;
      const bool is_read = parse_number(first, word.data() + word.size(), value) == Parsed::ok &&
                           std::isfinite(value);
      if (!is_read || first != word.data() + word.size())
        source_.fail(key + " of OpenCV's file has " + quoted(word) + ", which is no finite number");
      entries.push_back(value);
      text.remove_prefix(word.size());
    }
  }

  const Source& source_;
  bool is_xml_;
};

Eigen::Matrix3d rotation_of(const Vec3& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  const Vec3 axis = vector / angle;
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  // Rodrigues' formula.
  return Eigen::Matrix3d::Identity() + elementary::sin(angle) * cross +
         (1 - elementary::cos(angle)) * cross * cross;
}

LensDistortion distortion_of(const Storage& storage) {
  LensDistortion distortion;
  const auto found = storage.find({"distortion_coefficients", "distCoeffs", "dist_coeffs", "D"});
  if (!found) return distortion;
  // Models with more coefficients have a thin prism and a tilted sensor.
  for (std::size_t i = 8; i < found->size(); ++i)
    if ((*found)[i] != 0)
      storage.fail(
          "distortion beyond k1 k2 p1 p2 k3 k4 k5 k6 is not taken out here: undistort the "
          "images first");
  auto& [k1, k2, k3, k4, k5, k6] = distortion.radial;
  const std::array order{
      &k1, &k2, distortion.tangential.data(), distortion.tangential.data() + 1, &k3, &k4, &k5, &k6};
  for (std::size_t i = 0; i < std::min(found->size(), order.size()); ++i) *order[i] = (*found)[i];
  return distortion;
}

Eigen::Matrix3d intrinsics_of(const Storage& storage) {
  const Entries entries = storage.get({"camera_matrix", "cameraMatrix", "K", "M"});
  if (entries.size() != 9) storage.fail("camera_matrix of OpenCV's file has no 9 numbers");
  Eigen::Matrix3d k;
  for (int i = 0; i < 9; ++i) k(i / 3, i % 3) = entries[static_cast<std::size_t>(i)];
  if (k(1, 0) != 0 || k.row(2) != Eigen::RowVector3d(0, 0, 1))
    storage.fail(
        "camera_matrix of OpenCV's file must end with 0 0 1 and have 0 below its diagonal");
  const std::string problem = intrinsics_problem(k, "camera_matrix");
  if (!problem.empty()) storage.fail(problem);
  return k;
}

/// Reads rows of a rotation vector and t, or R and t of a single camera.
std::vector<PinholeCamera> poses_of(const Storage& storage) {
  std::vector<PinholeCamera> poses;
  if (const auto rows = storage.find({"extrinsic_parameters", "extrinsics"})) {
    if (rows->empty() || rows->size() % 6 != 0)
      storage.fail("extrinsic_parameters of OpenCV's file must have rows of 6 numbers");
    for (std::size_t i = 0; i < rows->size(); i += 6) {
      PinholeCamera pose;
      pose.rotation = rotation_of(Vec3(rows->data() + i));
      pose.translation = Vec3(rows->data() + i + 3);
      poses.push_back(pose);
    }
    return poses;
  }
  const Entries r = storage.get({"R", "rotation", "rvec"});
  const Entries t = storage.get({"T", "t", "translation", "tvec"});
  if ((r.size() != 9 && r.size() != 3) || t.size() != 3)
    storage.fail("R of OpenCV's file must have 9 numbers or 3, and T 3");
  PinholeCamera pose;
  pose.translation = Vec3(t.data());
  if (r.size() == 3) {
    pose.rotation = rotation_of(Vec3(r.data()));
  } else {
    for (int i = 0; i < 9; ++i) pose.rotation(i / 3, i % 3) = r[static_cast<std::size_t>(i)];
  }
  return {pose};
}

void add_matrix(const char* key, int rows, int columns, const std::vector<double>& numbers,
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

}  // namespace

std::string write_opencv(const CameraRecord& record) {
  const PinholeCamera& camera = record.camera;
  if (camera.intrinsics(0, 1) != 0) {
    throw InputError("OpenCV's pinhole has no skew, but the camera of " + quoted(record.name) +
                     " has (" + record.place + ")");
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
  add_matrix("camera_matrix", 3, 3, numbers_of(camera.intrinsics), text);
  const std::vector<double> distortion = numbers_of(record.distortion);
  add_matrix("distortion_coefficients", static_cast<int>(distortion.size()), 1, distortion, text);
  add_matrix("R", 3, 3, numbers_of(camera.rotation), text);
  const Vec3& t = camera.translation;
  add_matrix("T", 3, 1, {t.x(), t.y(), t.z()}, text);
  return text.take();
}

CameraList read_opencv(const Source& source, const std::string& stem) {
  const Storage storage(source);
  CameraRecord record;
  record.camera.intrinsics = intrinsics_of(storage);
  record.distortion = distortion_of(storage);
  record.width = storage.side("image_width");
  record.height = storage.side("image_height");
  if (record.width == 0 || record.height == 0) record.width = record.height = 0;
  record.place = source.name;

  CameraList list;
  for (const PinholeCamera& pose : poses_of(storage)) {
    const Eigen::Matrix3d& r = pose.rotation;
    const bool is_rotation = (r * r.transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-4);
    if (!is_rotation || r.determinant() < 0) storage.fail("R of OpenCV's file is no rotation");
    const std::string problem = translation_problem(pose.translation, "OpenCV's file");
    if (!problem.empty()) storage.fail(problem);
    record.camera.rotation = r;
    record.camera.translation = pose.translation;
    record.name = std::string(stem).append("-").append(std::to_string(list.cameras.size() + 1));
    list.cameras.push_back(record);
  }
  if (list.cameras.size() == 1) list.cameras[0].name = stem;
  return list;
}

}  // namespace transformesh
