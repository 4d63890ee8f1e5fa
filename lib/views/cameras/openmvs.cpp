// Scenes of OpenMVS in its interface format, versions 1 to 7. Reference: OpenMVS's manual,
// "Interface", and its header libs/MVS/Interface.h.
#include "views/cameras/camera_formats.h"
#include "views/cameras/camera_names.h"
#include "views/cameras/camera_pose.h"
#include "views/cameras/little_endian.h"

namespace transformesh {
namespace {

constexpr std::uint32_t newest_version = 7;  ///< newest version of the format that was tested
/// Number in the file that marks an image without pose.
constexpr std::uint32_t no_pose = 0xffffffff;

/// Rotation and center, relative to the world or to the platform that carries the camera.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 center = Vec3::Zero();
};

struct PlatformCamera {
  std::uint32_t width = 0, height = 0;
  Eigen::Matrix3d intrinsics = Eigen::Matrix3d::Identity();
  Pose pose;
};

struct Platform {
  std::vector<PlatformCamera> cameras;
  std::vector<Pose> poses;
};

class Scene {
 public:
  explicit Scene(const Source& source) : source_(source), rest_(source, "the OpenMVS scene") {
    rest_.take_bytes(4);  // signature
    version_ = rest_.take<std::uint32_t>();
    rest_.take<std::uint32_t>();  // reserved
    if (version_ < 1 || version_ > newest_version)
      source.fail("the OpenMVS scene has version " + std::to_string(version_) +
                  "; 1 to 7 are read");
  }

  CameraList read() {
    const auto platforms = rest_.take<std::uint64_t>();
    for (std::uint64_t i = 0; i < platforms; ++i) platforms_.push_back(read_platform());
    CameraList list;
    list.names_images = true;
    const auto images = rest_.take<std::uint64_t>();
    for (std::uint64_t i = 0; i < images; ++i) read_image(i, list);
    if (list.cameras.empty()) source_.fail("no image of the OpenMVS scene has a pose");
    remove_common_folder(list);
    return list;
  }

 private:
  std::string read_text() {
    const auto size = rest_.take<std::uint64_t>();
    return std::string(rest_.take_bytes(size));
  }

  Eigen::Matrix3d read_matrix() {
    Eigen::Matrix3d matrix;
    for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = rest_.take<double>();
    return matrix;
  }

  Pose read_pose() {
    Pose pose;
    pose.rotation = read_matrix();
    for (double& coordinate : pose.center) coordinate = rest_.take<double>();
    return pose;
  }

  PlatformCamera read_camera() {
    PlatformCamera camera;
    read_text();                    // name
    if (version_ > 3) read_text();  // spectral band
    camera.width = rest_.take<std::uint32_t>();
    camera.height = rest_.take<std::uint32_t>();
    camera.intrinsics = read_matrix();
    camera.pose = read_pose();
    return camera;
  }

  Platform read_platform() {
    Platform platform;
    read_text();  // name
    const auto cameras = rest_.take<std::uint64_t>();
    for (std::uint64_t i = 0; i < cameras; ++i) platform.cameras.push_back(read_camera());
    const auto poses = rest_.take<std::uint64_t>();
    for (std::uint64_t i = 0; i < poses; ++i) platform.poses.push_back(read_pose());
    return platform;
  }

  void read_image(std::uint64_t index, CameraList& list) {
    CameraRecord record;
    record.name = read_text();
    record.place = source_.name + " image " + std::to_string(index);
    if (version_ > 4) read_text();  // mask
    const auto platform = rest_.take<std::uint32_t>();
    const auto camera = rest_.take<std::uint32_t>();
    const auto pose = rest_.take<std::uint32_t>();
    if (version_ > 2) rest_.take<std::uint32_t>();  // identifier
    if (version_ > 6) {
      rest_.skip(3, 4);                                // depths
      rest_.skip(rest_.take<std::uint64_t>(), 6 * 4);  // scores of other views
    }
    if (pose == no_pose) return;
    const std::string who = "image " + in_quotes(record.name);
    if (platform >= platforms_.size() || camera >= platforms_[platform].cameras.size() ||
        pose >= platforms_[platform].poses.size())
      source_.fail(who + " of the OpenMVS scene has no camera");
    place(platforms_[platform].cameras[camera], platforms_[platform].poses[pose], who, record);
    list.cameras.push_back(std::move(record));
  }

  /// Sets the camera of `record`: composes the pose of the platform and the pose of the camera on
  /// the platform. If the image size is missing, intrinsics are fractions of the image's larger
  /// side. Integer coordinates are pixel centers.
  void place(const PlatformCamera& camera, const Pose& pose, const std::string& who,
             CameraRecord& record) {
    if (camera.width > 0 && camera.height > 0) {
      record.width = static_cast<int>(std::min(camera.width, 1000000000U));
      record.height = static_cast<int>(std::min(camera.height, 1000000000U));
    } else {
      record.unit = IntrinsicsUnit::larger_side;
    }
    record.camera.intrinsics = camera.intrinsics;
    std::string problem = intrinsics_problem(camera.intrinsics, who);
    if (problem.empty())
      problem = set_pose_at(camera.pose.rotation * pose.rotation,
                            pose.rotation.transpose() * camera.pose.center + pose.center, who,
                            record.camera);
    if (!problem.empty()) source_.fail(problem);
  }

  const Source& source_;
  LittleEndianReader rest_;
  std::uint32_t version_ = 0;
  std::vector<Platform> platforms_;
};

}  // namespace

CameraList read_openmvs(const Source& source) { return Scene(source).read(); }

}  // namespace transformesh
