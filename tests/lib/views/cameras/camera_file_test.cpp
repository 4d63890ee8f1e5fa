#include "views/cameras/camera_file.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdio>

#include "helpers/camera_texts.h"
#include "helpers/random.h"

using namespace transformesh;
using test::is_refused;
using test::refusal;

namespace {

PinholeCamera random_camera(test::Random& random) {
  PinholeCamera camera;
  camera.intrinsics << random.uniform(200, 4000), 0, random.uniform(100, 900), 0,
      random.uniform(200, 4000), random.uniform(100, 900), 0, 0, 1;
  const double angle = random.uniform(0, 3);
  camera.rotation = Eigen::AngleAxisd(angle, random.point(-1, 1).normalized()).toRotationMatrix();
  camera.translation = random.point(-3, 3);
  return camera;
}

CameraList random_cameras(std::size_t count, std::uint64_t seed) {
  test::Random random(seed);
  CameraList list;
  list.names_images = true;
  for (std::size_t i = 0; i < count; ++i) {
    CameraRecord record;
    record.name = "view" + std::to_string(i) + ".png";
    record.camera = random_camera(random);
    record.width = 640;
    record.height = 480;
    list.cameras.push_back(record);
  }
  return list;
}

// The largest difference between the pixels of some points.
double pixel_difference(const PinholeCamera& first, const PinholeCamera& second) {
  test::Random random(7);
  double largest = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 in_camera = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(2, 9)};
    const Vec3 point = first.rotation.transpose() * (in_camera - first.translation);
    const Eigen::Vector2d a = (first.projection() * point.homogeneous()).hnormalized();
    const Eigen::Vector2d b = (second.projection() * point.homogeneous()).hnormalized();
    largest = std::max(largest, (a - b).norm());
  }
  return largest;
}

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

  // As Bundler's manual has it: P = R X + t, p = -P / P.z, pixel f r(p) p from the center, y
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

TEST_CASE("cameras at the limits of the reader are written readably, or not at all") {
  test::Random random(9);
  std::array<int, 2> counts{};
  for (int round = 0; round < 2000; ++round) {
    CameraList list = random_cameras(2, static_cast<std::uint64_t>(round));
    Eigen::Matrix3d& k = list.cameras[0].camera.intrinsics;
    k(1, 2) = 0;
    k(0, 2) = k(0, 0) * 1e12 * (1 + random.uniform(-1e-3, 1e-3));
    for (const CameraFormat format :
         {CameraFormat::middlebury, CameraFormat::colmap, CameraFormat::matrices}) {
      std::string text;
      try {
        text = write_cameras(list, format);
      } catch (const InputError&) {
        ++counts[0];
        continue;
      }
      ++counts[1];
      CHECK(parse_cameras(text, "back.txt").cameras.size() == 2);
    }
  }
  CHECK(counts[0] > 500);
  CHECK(counts[1] > 500);
}

TEST_CASE("formats are distinguished by their content") {
  CHECK(camera_format("16\na.png 1") == CameraFormat::middlebury);
  CHECK(camera_format("# Camera list\n1 PINHOLE 3 4 5") == CameraFormat::colmap);
  CHECK(camera_format("1 1 0 0 0 0 0 5 1 a.png") == CameraFormat::colmap);
  CHECK(camera_format("# Bundle file v0.3\n") == CameraFormat::bundler);
  CHECK(camera_format("1 2 3 4\n") == CameraFormat::matrices);
  CHECK(camera_format("CONTOUR\n") == CameraFormat::matrices);
  for (const char* other : {"", "OFF\n3 1 0\n", "hello", "ply\nformat", "12 34 name.png\n",
                            "The OBJECT is 3", "1 2 3\n", "name.png\n"}) {
    CAPTURE(other);
    CHECK_FALSE(camera_format(other).has_value());
  }
  CHECK_FALSE(camera_format(std::string_view("1\n\0", 3)).has_value());
  CHECK(refusal("").find("empty") != std::string::npos);
  CHECK(refusal("OFF\n3 1 0\n").find("'OFF") != std::string::npos);
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

TEST_CASE("written cameras are read back") {
  const CameraList list = random_cameras(9, 5);
  const auto check_back = [&](CameraFormat format, double tolerance) {
    const CameraList back = parse_cameras(write_cameras(list, format), "back.txt");
    REQUIRE(back.cameras.size() == list.cameras.size());
    for (std::size_t i = 0; i < back.cameras.size(); ++i) {
      CHECK(back.cameras[i].name == list.cameras[i].name);
      CHECK(pixel_difference(list.cameras[i].camera, back.cameras[i].camera) <= tolerance);
    }
    return back;
  };
  check_back(CameraFormat::middlebury, 0);
  check_back(CameraFormat::matrices, 1e-9);
  const CameraList colmap = check_back(CameraFormat::colmap, 1e-9);
  CHECK(colmap.cameras[3].width == 640);
  CHECK(colmap.cameras[3].height == 480);
}

TEST_CASE("cameras that a format cannot hold are refused") {
  const auto refused = [](CameraList list, CameraFormat format, const char* what) {
    try {
      write_cameras(list, format);
    } catch (const InputError& error) {
      return std::string(error.what()).find(what) != std::string::npos;
    }
    return false;
  };
  CameraList list = random_cameras(2, 5);
  CHECK(refused(list, CameraFormat::bundler, "not written"));
  list.cameras[1].camera.intrinsics(0, 1) = 0.5;
  CHECK(refused(list, CameraFormat::colmap, "skew"));
  list.cameras[0].width = 0;
  CHECK(refused(list, CameraFormat::colmap, "sizes"));
  list.cameras[0].name = "a b.png";
  CHECK(refused(list, CameraFormat::middlebury, "'a b.png'"));
  list = random_cameras(2, 5);
  for (const std::string& name : {std::string(), std::string(" a"), std::string("a "),
                                  std::string("a\tb"), std::string("a\rb"), std::string(1, '\0')}) {
    list.cameras[1].name = name;
    for (const CameraFormat format :
         {CameraFormat::middlebury, CameraFormat::colmap, CameraFormat::matrices})
      CHECK(refused(list, format, "can hold the name"));
  }
  list.cameras[0].is_centered = true;
  CHECK(refused(list, CameraFormat::matrices, "principal point"));
}

TEST_CASE("files of a folder have the names that the format's programs expect") {
  const CameraList list = random_cameras(2, 5);
  const auto names = [&](CameraFormat format) {
    std::string found;
    for (const CameraText& file : write_camera_files(list, format)) found += file.name + ' ';
    return found;
  };
  CHECK(names(CameraFormat::middlebury) == "cameras_par.txt ");
  CHECK(names(CameraFormat::colmap) == "cameras.txt images.txt points3D.txt ");
  CHECK(names(CameraFormat::matrices) == "view0.txt view1.txt ");
}

TEST_CASE("matrices of a folder are each in a file of its own that is found there") {
  for (const char* name : {"left/view0.png", "view0.jpg", ".view1.png"}) {
    CameraList list = random_cameras(2, 5);
    list.cameras[1].name = name;
    CHECK_THROWS_AS(write_camera_files(list, CameraFormat::matrices), InputError);
    CHECK_NOTHROW(write_camera_files(list, CameraFormat::colmap));
  }
}
