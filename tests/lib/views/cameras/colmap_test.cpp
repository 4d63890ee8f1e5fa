#include <doctest/doctest.h>

#include <cmath>

#include "helpers/camera_texts.h"

using namespace transformesh;
using test::is_refused;
using test::refusal;

namespace {

const std::string colmap_lens = "# a comment\n1 PINHOLE 320 240 300 310 160.5 120.5\n";

}  // namespace

TEST_CASE("COLMAP: quaternions rotate from the world, and pixels are shifted by a half") {
  const double half_angle = 0.35;
  const std::string turn =
      std::to_string(std::cos(half_angle)) + " 0 0 " + std::to_string(std::sin(half_angle));
  const auto list = parse_cameras(colmap_lens + "2 SIMPLE_PINHOLE 64 48 50 32 24\n" + "7 " + turn +
                                      " 1 2 3 1 a b.png\n\n" + "8 1 0 0 0 0 0 0 2 c.png\n1 2 -1\n",
                                  "some.txt");
  REQUIRE(list.cameras.size() == 2);
  const CameraRecord& first = list.cameras[0];
  CHECK(first.name == "a b.png");
  CHECK(first.width == 320);
  CHECK(first.height == 240);
  CHECK(first.camera.intrinsics(0, 2) == 160);
  CHECK(first.camera.intrinsics(1, 2) == 120);
  CHECK(first.camera.intrinsics(1, 1) == 310);
  CHECK(first.camera.rotation(0, 0) == doctest::Approx(std::cos(0.7)).epsilon(1e-5));
  CHECK(first.camera.rotation(0, 1) == doctest::Approx(-std::sin(0.7)).epsilon(1e-5));
  CHECK(first.camera.rotation(2, 2) == doctest::Approx(1));
  CHECK(first.camera.translation == Vec3(1, 2, 3));
  CHECK(list.cameras[1].camera.intrinsics(0, 0) == 50);
  CHECK(list.cameras[1].camera.intrinsics(1, 1) == 50);
  CHECK(list.cameras[1].camera.intrinsics(1, 2) == 23.5);
}

TEST_CASE("COLMAP: every mistake is refused with its line") {
  const std::string image = "1 1 0 0 0 0 0 5 1 a.png\n\n";
  CHECK(refusal(colmap_lens + image).empty());
  CHECK(refusal(colmap_lens + "1 1 0 0 0 0 0 5 1 a.png").empty());
  CHECK(is_refused("1 FOV 320 240 300 310 160 120 0 0 0 0\n" + image, "'FOV'", 1));
  CHECK(is_refused("1 RADIAL_FISHEYE 320 240 300 160 120 0 0\n" + image, "undistort", 1));
  CHECK(is_refused("1 RADIAL 320 240 300 160 120 0\n" + image, "k2 of camera '1'", 1));
  CHECK(is_refused(colmap_lens + colmap_lens + image, "camera '1' is listed twice", 4));
  CHECK(is_refused("1 PINHOLE 0 240 300 310 160 120\n" + image, "width", 1));
  CHECK(is_refused("1 PINHOLE 320 240 300 310 160\n" + image, "cy of camera '1'", 1));
  CHECK(is_refused("1 PINHOLE 320 240 300 nan 160 120\n" + image, "second focal length", 1));
  CHECK(is_refused("1 PINHOLE 320 240 -300 310 160 120\n" + image, "positive", 1));
  CHECK(is_refused(colmap_lens, "no image", 3));
  CHECK(is_refused(colmap_lens + "1 1 0 0 0 0 0 5 2 a.png\n\n", "no camera '2'", 3));
  CHECK(is_refused(colmap_lens + "1 0 0 0 0 0 0 5 1 a.png\n\n", "quaternion", 3));
  CHECK(is_refused(colmap_lens + "1 1 0 0 0 0 0 5 1 \n\n", "name of image '1'", 3));
  CHECK(is_refused(colmap_lens + "1 1 0 0 0 0 0 5 1 a.png\n2 1 0 0 0 0 0 5 1 b.png\n",
                   "line of points", 4));
}

TEST_CASE("COLMAP: after an image, only a list of points is accepted") {
  const std::string image = "1 1 0 0 0 0 0 5 1 a.png\n";
  CHECK(refusal(colmap_lens + image + "1.5 2 -1 3 4.5 77\n").empty());
  CHECK(refusal(colmap_lens + image + " \t\r\n").empty());
  CHECK(is_refused(colmap_lens + image + "1.5 2\n", "line of points", 4));
}

TEST_CASE("COLMAP: lines are distinguished from other rows of numbers") {
  CHECK(camera_format("3 PINHOLE 320 240 300 310 160 120") == CameraFormat::colmap);
  CHECK_FALSE(camera_format("3 PINHOLE wide 240 300 310 160 120").has_value());
  CHECK_FALSE(camera_format("1 1 0 0 0 0 0 5 a.png").has_value());
}
