#include "helpers/camera_pixels.h"

using namespace transformesh;
using test::refuses;

namespace {

std::string file(const std::string& title, const std::string& focal, const std::string& end) {
  const test::TruePose pose;
  const Eigen::Quaterniond q(pose.rotation);
  const Eigen::Vector4d wxyz(q.w(), q.x(), q.y(), q.z());
  return title + "\n\n1\n/a/photo\"one.jpg\t" + focal + " " + test::joined(wxyz.transpose(), " ") +
         " " + test::joined(pose.center.transpose(), " ") + " " + end + "\n\n0\n";
}

CameraRecord read(const std::string& text) {
  const CameraList list = parse_cameras(text, "model.nvm");
  REQUIRE(list.cameras.size() == 1);
  CHECK(list.cameras[0].name == "photo one.jpg");
  return list.cameras[0];
}

}  // namespace

TEST_CASE("VisualSFM: pixels around the image's center, or by fixed intrinsics") {
  CameraRecord record = read(file("NVM_V3 ", "500", "0 0"));
  record.set_size(640, 480, "a.jpg");
  test::check_pixels(
      record, [](double x, double y) { return Eigen::Vector2d(500 * x + 319.5, 500 * y + 239.5); });
  test::check_pixels(
      read(file("NVM_V3 FixedK 500 322 510 235 0", "1", "0 0")),
      [](double x, double y) { return Eigen::Vector2d(500 * x + 322, 510 * y + 235); });
}

TEST_CASE("VisualSFM: distortion is removed from pixels by its formula") {
  // The formula: p (1 + r |p|^2) is the pinhole's point, p the point in the photograph.
  const double r = 0.08;
  const CameraRecord record = read(file("NVM_V3", "1000", "0.08 0"));
  for (const double x : {0.1, 0.3, 0.5}) {
    const Eigen::Vector2d seen(x, 0.6 * x);
    const Eigen::Vector2d straight = seen * (1 + r * seen.squaredNorm());
    CHECK((record.distortion.distorted(straight.x(), straight.y()) - seen).norm() * 1000 < 0.1);
  }
}

TEST_CASE("VisualSFM: what is no camera is refused with its line") {
  CHECK(refuses(file("NVM_V3", "0", "0 0"), "positive"));
  CHECK(refuses(file("NVM_V3", "nan", "0 0"), "focal length"));
  CHECK(refuses(file("NVM_V3", "500", "0.5 0"), "undistort"));
  CHECK(refuses("NVM_V3\n1\na.jpg 500 1 1 0 0 0 0 0 0 0\n", "quaternion"));
  CHECK(
      refuses("NVM_V3\n1000000000000\na.jpg 500 1 0 0 0 0 0 0 0 0\n", "after 1 of 1000000000000"));
  CHECK(refuses("NVM_V3\n0\n", "no camera"));
  CHECK(refuses("NVM_V3\n", "number of cameras"));
  CHECK(refuses("NVM_V3 FixedK 500\n1\n", "cx of FixedK"));
  test::check_damaged(file("NVM_V3", "500", "0 0"));
}
