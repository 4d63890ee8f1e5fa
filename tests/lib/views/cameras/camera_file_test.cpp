#include "views/cameras/camera_file.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdio>

#include "helpers/camera_texts.h"
#include "helpers/random.h"
#include "helpers/random_cameras.h"
#include "raster/camera.h"
#include "views/cameras/camera_output.h"

using namespace transformesh;
using test::is_refused;
using test::random_camera;
using test::random_cameras;
using test::refusal;

namespace {

std::string exact(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

const std::string bundle = "# Bundle file v0.3\n1 0\n";

}  // namespace

TEST_CASE("Bundler: looks along -z with y up, around the image's center") {
  const double f = 500;
  const Eigen::Matrix3d r = Eigen::AngleAxisd(0.4, Vec3(1, 2, 2) / 3).toRotationMatrix();
  const Vec3 t(0.2, -0.3, -6);
  const double k1 = 0.2, k2 = -0.3;
  std::string text = bundle + "500 0.2 -0.3\n";
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      text += exact(r(i, j)) + ' ';
    }
    text += '\n';
  }
  auto list = parse_cameras(text + "0.2 -0.3 -6\n", "bundle.out");
  REQUIRE(list.cameras.size() == 1);
  CHECK_FALSE(list.names_images);
  list.cameras[0].set_size(641, 481, "a.png");

  // The formula of Bundler's manual: P = R X + t, p = -P / P.z, pixel f r(p) p from the center, y
  // upwards, where r(p) = 1 + k1 |p|^2 + k2 |p|^4.
  const Vec3 point(0.5, 0.1, 0.3);
  const Vec3 in_camera = r * point + t;
  const Vec3 p = -in_camera / in_camera.z();
  const double size = p.head<2>().squaredNorm();
  const double bend = f * (1 + k1 * size + k2 * size * size);
  const Eigen::Vector2d expected(320 + bend * p.x(), 240 - bend * p.y());
  const PinholeCamera& camera = list.cameras[0].camera;
  const Vec3 seen = camera.rotation * point + camera.translation;
  CHECK(seen.z() > 0);
  const Eigen::Vector2d bent =
      list.cameras[0].distortion.distorted(seen.x() / seen.z(), seen.y() / seen.z());
  const Vec3 q = camera.intrinsics * bent.homogeneous();
  CHECK((q.hnormalized() - expected).norm() < 1e-9);
}

TEST_CASE("Bundler: every mistake is refused with its line") {
  const std::string pose = "1 0 0\n0 1 0\n0 0 1\n0 0 -5\n";
  CHECK(refusal(bundle + "500 0 0\n" + pose).empty());
  CHECK(is_refused(bundle + "500 0.1 k\n" + pose, "k2", 3));
  CHECK(is_refused(bundle + "0 0 0\n" + pose, "could not place", 3));
  CHECK(is_refused(bundle + "-5 0 0\n" + pose, "positive", 3));
  CHECK(is_refused("# Bundle file v0.2\n1 0\n500 0 0\n" + pose, "version 0.3", 1));
  CHECK(is_refused("# Bundle file v0.3\n2 0\n500 0 0\n" + pose, "camera 1", 8));
  CHECK(is_refused("# Bundle file v0.3\n0 0\n", "no camera", 2));
  CHECK(is_refused(bundle + "500 0 0\n1 0 0\n0 1 0\n0 0 1 4\n0 0 -5\n", "more values", 6));
  CHECK(is_refused(bundle + "500 0 0\n1 0 0\n0 1 0\n0 0 x\n0 0 -5\n", "row 3 of R", 6));
}

TEST_CASE("a projection matrix of any scale and sign is decomposed into its factors") {
  test::Random random(3);
  for (int round = 0; round < 200; ++round) {
    PinholeCamera camera = random_camera(random);
    camera.intrinsics(0, 1) = random.uniform(-5, 5);
    const double scale = std::pow(10, random.uniform(-6, 6)) * (round % 2 == 0 ? 1 : -1);
    const Projection p = scale * camera.projection();
    std::string text;
    for (int i = 0; i < 12; ++i) {
      text += exact(p(i / 4, i % 4)) + (i % 4 == 3 ? "\n" : " ");
    }
    const auto list = parse_cameras(text, "folder/cam.007.P");
    REQUIRE(list.cameras.size() == 1);
    CHECK(list.cameras[0].name == "cam.007");
    const PinholeCamera& found = list.cameras[0].camera;
    CHECK((found.intrinsics - camera.intrinsics).norm() < 1e-8);
    CHECK((found.rotation - camera.rotation).norm() < 1e-11);
    CHECK((found.translation - camera.translation).norm() < 1e-10);
    CHECK(found.intrinsics(2, 2) == 1);
  }
}

TEST_CASE("matrices: rows of four or one of twelve, with names or Furukawa's first line") {
  const std::string matrix = "300 0 160 0\n0 300 120 0\n0 0 1 5\n";
  CHECK(parse_cameras("CONTOUR\n" + matrix, "a.txt").cameras.size() == 1);
  CHECK(parse_cameras("300 0 160 0 0 300 120 0 0 0 1 5", "a.txt").cameras.size() == 1);
  const auto named = parse_cameras("# left\n" + matrix + "# right\n" + matrix, "a.txt");
  REQUIRE(named.cameras.size() == 2);
  CHECK(named.cameras[0].name == "left");
  CHECK(named.cameras[1].name == "right");
  CHECK(named.cameras[1].place == "a.txt line 6");
  CHECK(parse_cameras(matrix + matrix, "a.txt").cameras[1].name == "a-2");
  CHECK(parse_cameras("# projection matrix\n" + matrix, "a.txt").cameras[0].name == "a");
  const auto odd = parse_cameras("#  left \t\r\n" + matrix + "# \n" + matrix, "a.txt");
  CHECK(odd.cameras[0].name == "left");
  CHECK(odd.cameras[1].name == "a-2");
  CHECK(parse_cameras("# Bundle file v0.3\n" + matrix, "a.txt").cameras.size() == 1);
}

TEST_CASE("matrices: every mistake is refused with its line") {
  CHECK(is_refused("1 0 0 0\n0 1 0 0\n", "ends after 8 of 12", 3));
  CHECK(is_refused("1 0 0 0\n0 1 0\n0 0 1 0\n", "number 8 of matrix 1", 2));
  CHECK(is_refused("1 0 0 0\n0 1 0 0 0\n0 0 1 0\n", "more values", 2));
  CHECK(is_refused("1 0 0 0\n0 1 0 0\n0 0 nan 0\n", "number 11 of matrix 1", 3));
  CHECK(is_refused("1 0 0 0\n0 one 0 0\n0 0 1 0\n", "number 6 of matrix 1", 2));
  CHECK(is_refused("1 2 3 0\n4 5 6 0\n7 8 9 1\n", "singular", 3));
  CHECK(is_refused("0 0 0 0\n0 0 0 0\n0 0 0 0\n", "singular", 3));
  CHECK(is_refused("1 0 0 0\n0 1 0 0\n0 0 0 1\n", "singular", 3));
}

TEST_CASE("cameras whose products or inverses overflow are refused") {
  const std::string pose = " 1 0 0 0 1 0 0 0 1 0 0 5\n";
  CHECK(refusal("1\na.png 9 0 1e12 0 9 0 0 0 1" + pose).empty());
  CHECK(is_refused("1\na.png 9 0 1e13 0 9 0 0 0 1" + pose, "is singular", 2));
  CHECK(is_refused("1\na.png 9 0 0 0 9 -1e13 0 0 1" + pose, "is singular", 2));
  CHECK(is_refused("1\na.png 9 1e13 0 0 9 0 0 0 1" + pose, "is singular", 2));
  CHECK(is_refused("1\na.png 9 0 0 0 9 0 0 0 1e-120" + pose, "out of range", 2));
  CHECK(is_refused("1\na.png 1e-101 0 0 0 1e-101 0 0 0 1" + pose, "out of range", 2));
  CHECK(is_refused("1\na.png 9 0 0 0 9 0 0 0 1 1 0 0 0 1 0 0 0 1 0 0 1e101\n", "t of", 2));
  CHECK(is_refused("1 PINHOLE 320 240 9 9 1e48 120\n1 1 0 0 0 0 0 1 1 a.png\n", "singular", 1));
  CHECK(is_refused("1 PINHOLE 3 2 9 9 1 1\n1 1 0 0 0 1e200 0 1 1 a.png\n", "out of range", 2));
  CHECK(is_refused(bundle + "1e200 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -5\n", "out of range", 3));
  CHECK(is_refused(bundle + "9 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1e200\n", "out of range", 7));
}

TEST_CASE("damaged files are refused with their name, or read as valid cameras") {
  const CameraList list = random_cameras(2, 8);
  const std::string pose = "1 0 0\n0 1 0\n0 0 1\n0 0 -5\n";
  const std::vector<std::string> texts{
      write_cameras(list, CameraFormat::middlebury), write_cameras(list, CameraFormat::colmap),
      write_cameras(list, CameraFormat::matrices), bundle + "500 0 0\n" + pose};
  const std::string_view replacements = " \n#-.0e9nx\t\r\xff";
  test::Random random(4);
  for (const std::string& text : texts) {
    for (int round = 0; round < 2000; ++round) {
      std::string damaged =
          text.substr(0, round % 3 == 0 ? random.below(text.size()) : text.size());
      for (int i = 0; i < 3 && !damaged.empty(); ++i) {
        damaged[random.below(damaged.size())] = replacements[random.below(replacements.size())];
      }
      try {
        for (const CameraRecord& record : parse_cameras(damaged, "some.txt").cameras) {
          CHECK(record.camera.projection().allFinite());
          CHECK(record.camera.rotation.determinant() == doctest::Approx(1).epsilon(1e-2));
          CHECK(record.camera.intrinsics.diagonal().minCoeff() > 0);
        }
      } catch (const InputError& error) {
        CHECK(std::string(error.what()).find("some.txt") != std::string::npos);
      }
    }
  }
}
