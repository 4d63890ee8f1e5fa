// The cameras.sfm of Meshroom: AliceVision's scene as JSON, of versions 1.0 to 1.2. Reference:
// AliceVision's list of changes to its file formats (src/aliceVision/sfmDataIO/CHANGES.md).
#include <algorithm>
#include <map>

#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_names.h"
#include "views/cameras/camera_pose.h"
#include "views/cameras/json_entry.h"

namespace transformesh {
namespace {

/// Each constant is the first revision of a changed intrinsic parameter in cameras.sfm. A revision
/// is the third number x of version 1.2.x.
constexpr int relative_principal_point = 1;
constexpr int focal_length_in_mm = 2;
constexpr int ratio_of_pixels = 5;  ///< older revisions store the inverse of `pixelRatio`

/// Lens parameters that several views share.
struct MeshroomLens {
  CameraRecord record;
  std::string problem;  ///< reason why the lens is not supported, or ""
};

/// Returns the revision x of version 1.2.x; -1 for older versions, 1000 for newer ones.
int revision_of(const JsonEntry& file) {
  const std::vector<double> version = file.at("version").numbers(3);
  if (version[0] != 1) file.at("version").fail("is not 1");
  if (version[1] > 2) return 1000;
  return version[1] < 2 ? -1 : static_cast<int>(std::min(version[2], 1000.0));
}

/// Returns the focal lengths along x and y, in pixels.
Eigen::Vector2d focals_of(const JsonEntry& entry, int revision, int width) {
  if (revision < 0 || !entry.has("focalLength")) {
    const JsonEntry focal = entry.at("pxFocalLength");
    if (!focal.is_list()) return Eigen::Vector2d::Constant(focal.number());
    const std::vector<double> both = focal.numbers(2);
    return {both[0], both[1]};
  }
  const double sensor = entry.number("sensorWidth", 36);
  const double ratio = entry.number("pixelRatio", 1);
  if (!(sensor > 0 && ratio > 0)) entry.fail("has no positive sensorWidth and pixelRatio");
  const double x = entry.at("focalLength").number() / sensor * width;
  return {x, revision < ratio_of_pixels ? x / ratio : x * ratio};
}

/// Returns "" if the distortion model is supported, else an error message.
std::string read_meshroom_distortion(const JsonEntry& entry, LensDistortion& distortion) {
  const std::string type = entry.text("type", "pinhole");
  const std::string model =
      type == "pinhole" ? entry.text("distortionType", "none") : entry.text("type", "");
  std::vector<double> k;
  if (entry.has("distortionParams"))
    for (const JsonEntry& number : entry.at("distortionParams").elements())
      k.push_back(number.number());
  const bool is_none = std::all_of(k.begin(), k.end(), [](double value) { return value == 0; });
  const bool is_radial = model == "radialk1" || model == "radialk3" || model == "radial1" ||
                         model == "radial3" || model == "radial";
  const bool is_brown = model == "brown" || model == "brownt2";
  const bool is_read = (is_radial && k.size() <= 3) || (is_brown && k.size() == 5);
  const bool is_pinhole = model == "none" || model == "pinhole" || is_radial || is_brown;
  if (!is_pinhole || (!is_none && !is_read))
    return "the lens model " + in_quotes(model) + " is not supported: undistort the images";
  k.resize(5, 0);
  distortion.radial = {k[0], k[1], k[2], 0, 0, 0};
  if (is_brown) distortion.tangential = {k[3], k[4]};
  return {};
}

MeshroomLens read_meshroom_lens(const JsonEntry& entry, int revision) {
  MeshroomLens lens;
  CameraRecord& record = lens.record;
  record.width = entry.at("width").side();
  record.height = entry.at("height").side();
  const Eigen::Vector2d focal = focals_of(entry, revision, record.width);
  const std::vector<double> point = entry.at("principalPoint").numbers(2);
  Eigen::Vector2d center(point[0], point[1]);
  if (revision >= relative_principal_point)
    center += Eigen::Vector2d(record.width, record.height) / 2;
  record.camera.intrinsics << focal.x(), 0, center.x(), 0, focal.y(), center.y(), 0, 0, 1;
  lens.problem = intrinsics_problem(record.camera.intrinsics, entry.place());
  if (lens.problem.empty()) lens.problem = read_meshroom_distortion(entry, record.distortion);
  return lens;
}

/// Reads a pose. The file contains the rotation matrix column by column.
void read_meshroom_pose(const JsonEntry& transform, PinholeCamera& camera) {
  const std::vector<double> numbers = transform.at("rotation").numbers(9);
  const std::vector<double> center = transform.at("center").numbers(3);
  const Eigen::Matrix3d rotation = Eigen::Map<const Eigen::Matrix3d>(numbers.data());
  const std::string problem = set_pose_at(rotation, Vec3(center.data()), "the pose", camera);
  if (!problem.empty()) transform.fail(": " + problem);
}

}  // namespace

CameraList read_meshroom(const Source& source) {
  const nlohmann::json json = parse_camera_json(source);
  const JsonEntry file(json, source);
  const int revision = revision_of(file);
  std::map<std::string, MeshroomLens> lenses;
  std::map<std::string, JsonEntry> poses;
  if (!file.has("poses"))
    source.fail("the Meshroom file has no poses: name the file that structure from motion wrote");
  for (const JsonEntry& entry : file.at("intrinsics").elements())
    lenses.emplace(entry.at("intrinsicId").text(), read_meshroom_lens(entry, revision));
  for (const JsonEntry& entry : file.at("poses").elements())
    poses.emplace(entry.at("poseId").text(), entry.at("pose").at("transform"));
  CameraList list;
  list.names_images = true;
  for (const JsonEntry& view : file.at("views").elements()) {
    // Views whose pose Meshroom could not determine have no entry in `poses`.
    const auto pose = poses.find(view.text("poseId", view.text("viewId", "")));
    if (pose == poses.end()) continue;
    if (view.has("rigId")) view.fail("belongs to a rig, which is not supported");
    const auto lens = lenses.find(view.at("intrinsicId").text());
    if (lens == lenses.end()) view.at("intrinsicId").fail("does not match any intrinsic");
    if (!lens->second.problem.empty()) view.fail(": " + lens->second.problem);
    CameraRecord record = lens->second.record;
    record.name = view.at("path").text();
    record.place = view.place();
    read_meshroom_pose(pose->second, record.camera);
    list.cameras.push_back(std::move(record));
  }
  if (list.cameras.empty()) source.fail("no view of the Meshroom file has a pose");
  remove_common_folder(list);
  return list;
}

}  // namespace transformesh
