#include "helpers/camera_pixels.h"

using namespace transformesh;
using test::refuses;

namespace {

std::string file(const std::string& intrinsic) {
  const test::TruePose pose;
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = pose.rotation;
  m.topRightCorner<3, 1>() = pose.translation();
  std::string text = "extrinsic\n";
  for (int i = 0; i < 4; ++i) text += test::joined(m.row(i), " ") + " \n";
  return text + "\nintrinsic\n" + intrinsic + "\n425.0 2.5 192 935.0\n";
}

const std::string lens = "500 0 322\n0 510 235\n0 0 1\n";

}  // namespace

TEST_CASE("MVSNet: pixels are COLMAP's, from which its files are converted") {
  const CameraList list = parse_cameras(file(lens), "cams/00000003_cam.txt");
  REQUIRE(list.cameras.size() == 1);
  CHECK(list.cameras[0].name == "00000003_cam");
  CHECK_FALSE(list.names_images);
  test::check_pixels(list.cameras[0], [](double x, double y) {
    return Eigen::Vector2d(500 * x + 322 - 0.5, 510 * y + 235 - 0.5);
  });
}

TEST_CASE("MVSNet: what is no camera is refused with its line") {
  CHECK(refuses(file("500 0 322\n0 510 235\n0 1 1\n"), "end with 0 0 1"));
  CHECK(refuses(file("500 0 322\n0 nan 235\n0 0 1\n"), "number 2 of row 2 of intrinsic"));
  CHECK(refuses(file("500 0 322\n"), "row 2 of intrinsic"));
  CHECK(refuses("extrinsic\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 2\n", "0 0 0 1"));
  CHECK(refuses("extrinsic\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\nfoo\n", "'intrinsic'"));
  CHECK(refuses("extrinsic\n1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n", "reflection"));
  test::check_damaged(file(lens));
}
