// The file meta.ini of a view of MVE (Multi-View Environment). Reference: Fuhrmann, Langguth &
// Goesele, "MVE: a multi-view reconstruction environment", GCH 2014, and the manual of its program,
// "Math cookbook".
#include <filesystem>
#include <map>

#include "io/streams/file_list.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_pose.h"
#include "views/images/image_file.h"

namespace transformesh {
namespace {

/// Name, without extension, of the file in the folder of each view that contains the undistorted
/// photograph.
constexpr const char* image_name = "undistorted";

/// The entries of the file, as a map from `section.key` to the text after the equals sign.
class Entries {
 public:
  explicit Entries(const Source& source) : source_(source) {
    TextRows rows(source, 0, {'#', false});
    std::string section;
    while (rows.next_row()) {
      const std::string row(rows.skip_row());
      const std::size_t equals = row.find('=');
      if (row.starts_with('[')) section = row.substr(1, row.find(']') - 1);
      if (row.starts_with('[') || equals == std::string::npos) continue;
      const std::string key = row.substr(0, row.find_last_not_of(" \t", equals - 1) + 1);
      entries_[section + '.' + key] = row.substr(equals + 1);
    }
  }

  /// Returns the numbers of the entry `key` of the section `camera`; `otherwise` if there is no
  /// such entry.
  std::vector<double> numbers(const char* key, std::vector<double> otherwise) const {
    const auto entry = entries_.find(std::string("camera.") + key);
    if (entry == entries_.end()) return otherwise;
    const Source text{entry->second, source_.name};
    std::vector<double> numbers;
    TextRows rows(text, 0, {'\0', false});
    rows.next_row();
    while (rows.has_more())
      numbers.push_back(rows.finite_number<double>([&] { return std::string(key); }));
    if (numbers.size() != otherwise.size())
      source_.fail(std::string(key) + " has " + std::to_string(numbers.size()) +
                   " numbers instead of " + std::to_string(otherwise.size()));
    return numbers;
  }

 private:
  const Source& source_;
  std::map<std::string, std::string> entries_;
};

/// Sets the size of the image if the undistorted image is in the same folder as the file `source`.
void set_size(const Source& source, CameraRecord& record) {
  const std::filesystem::path folder = std::filesystem::path(source.name).parent_path();
  for (const char* extension : {".png", ".jpg"}) {
    const std::string path = (folder / (image_name + std::string(extension))).string();
    if (!is_file(path)) continue;
    const GrayImage image = decode_size(file_bytes(path), path);
    record.set_size(image.width, image.height, path);
    return;
  }
}

/// Reads the intrinsics. The focal length is a fraction of the image's larger side; pixels must be
/// square. The principal point is a fraction of width and height.
void read_mve_lens(const Entries& entries, double focal, const Source& source,
                   CameraRecord& record) {
  const double aspect = entries.numbers("pixel_aspect", {1})[0];
  const std::vector<double> center = entries.numbers("principal_point", {0.5, 0.5});
  if (aspect != 1) source.fail("pixel_aspect is not 1: undistort the images");
  record.unit = IntrinsicsUnit::larger_side;
  record.is_centered = true;
  record.camera.intrinsics = Vec3(focal, focal, 1).asDiagonal();
  const std::string problem = intrinsics_problem(record.camera.intrinsics, "the view");
  if (!problem.empty()) source.fail(problem);
  set_size(source, record);
  if (center[0] == 0.5 && center[1] == 0.5) return;
  if (record.width == 0)
    source.fail("principal_point depends on the size of " + std::string(image_name) +
                ".png, which is missing beside the file");
  record.camera.intrinsics(0, 2) += (center[0] - 0.5) * record.width;
  record.camera.intrinsics(1, 2) += (center[1] - 0.5) * record.height;
}

}  // namespace

CameraList read_mve(const Source& source) {
  const Entries entries(source);
  CameraList list;
  list.names_images = true;
  // Views whose pose MVE could not determine have the focal length 0.
  const double focal = entries.numbers("focal_length", {0})[0];
  if (focal == 0) return list;
  CameraRecord record;
  const std::filesystem::path folder = std::filesystem::path(source.name).parent_path();
  record.name = (folder.filename() / image_name).string();
  record.place = source.name;
  read_mve_lens(entries, focal, source, record);
  const auto rotation = entries.numbers("rotation", {1, 0, 0, 0, 1, 0, 0, 0, 1});
  const auto translation = entries.numbers("translation", {0, 0, 0});
  Eigen::Matrix3d r;
  for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = rotation[static_cast<std::size_t>(i)];
  const std::string problem = set_pose(r, Vec3(translation.data()), "the view", record.camera);
  if (!problem.empty()) source.fail(problem);
  list.cameras.push_back(std::move(record));
  return list;
}

}  // namespace transformesh
