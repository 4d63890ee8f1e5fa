#include "helpers/camera_pixels.h"
#include "helpers/numpy_files.h"

using namespace transformesh;
using test::refuses;

namespace {

std::string word(std::uint32_t number) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 255U);
  return bytes;
}

std::string count(std::uint32_t number) { return word(number) + word(0); }

std::string text(const std::string& name) {
  return count(static_cast<std::uint32_t>(name.size())) + name;
}

std::string numbers(const Eigen::MatrixXd& matrix) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) values.push_back(matrix(i, j));
  return test::bytes_of<double>(values);
}

struct SceneParts {
  std::uint32_t version = 7;
  std::uint32_t width = 640, height = 480;
  double scale = 1;
  std::uint32_t pose = 0;
};

/// A camera that is rotated and moved on its platform, and an image without a pose.
std::string file(const SceneParts& parts) {
  const test::TruePose pose;
  const Eigen::Matrix3d on_platform = Eigen::AngleAxisd(0.3, Vec3(2, -1, 2) / 3).toRotationMatrix();
  const Vec3 center_on_platform(0.1, 0.2, 0.3);
  const Eigen::Matrix3d platform = on_platform.transpose() * pose.rotation;
  const Vec3 place = pose.center - platform.transpose() * center_on_platform;
  Eigen::Matrix3d k;
  k << 500, 0, 322, 0, 510, 235, 0, 0, 1;
  k.topRows<2>() *= parts.scale;
  const auto image = [&](const std::string& name, std::uint32_t pose_index) {
    std::string bytes = text("/x/" + name);
    if (parts.version > 4) bytes += text("mask.png");
    bytes += word(0) + word(0) + word(pose_index);
    if (parts.version > 2) bytes += word(9);
    if (parts.version > 6)
      bytes += test::bytes_of<float>({1, 2, 3}) + count(1) + std::string(6 * 4, 'x');
    return bytes;
  };
  std::string camera = text("camera");
  if (parts.version > 3) camera += text("RGB");
  camera += word(parts.width) + word(parts.height) + numbers(k) + numbers(on_platform) +
            numbers(center_on_platform);
  return "MVSI" + word(parts.version) + word(0) + count(1) + text("platform") + count(1) + camera +
         count(1) + numbers(platform) + numbers(place) + count(2) + image("a.jpg", parts.pose) +
         image("b.jpg", 0xffffffffU) + count(0);
}

}  // namespace

TEST_CASE("OpenMVS: pixels of cameras on platforms, of every version") {
  const auto expected = [](double x, double y) {
    return Eigen::Vector2d(500 * x + 322, 510 * y + 235);
  };
  for (const std::uint32_t version : {1U, 2U, 3U, 4U, 5U, 6U, 7U}) {
    const CameraList list = parse_cameras(file({version}), "scene.mvs");
    REQUIRE(list.cameras.size() == 1);
    CHECK(list.cameras[0].name == "a.jpg");
    CHECK(list.cameras[0].height == 480);
    test::check_pixels(list.cameras[0], expected);
  }
  // Without a size, intrinsics are fractions of the larger side.
  CameraRecord record = parse_cameras(file({5, 0, 0, 1.0 / 640}), "scene.mvs").cameras[0];
  record.set_size(640, 480, "a.jpg");
  test::check_pixels(record, expected);
}

TEST_CASE("OpenMVS: what is no camera is refused") {
  CHECK(refuses(file({8}), "version 8"));
  CHECK(refuses(file({7, 640, 480, -1}), "positive"));
  CHECK(refuses(file({7, 640, 480, std::nan("")}), "out of range"));
  CHECK(refuses(file({7, 640, 480, 1, 5}), "has no camera"));
  CHECK(refuses("MVSI" + word(7) + word(0) + word(0xffffffffU) + word(0xffffffffU), "too early"));
  CHECK(refuses("MVSI" + word(7) + word(0) + count(0) + count(0), "no image"));
  test::check_damaged(file({7}));
}
