#include "views/cameras/camera_output.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

#include "helpers/random_cameras.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_file.h"

using namespace transformesh;
using test::random_cameras;

namespace {

// Returns the largest difference between the pixels of some points.
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

}  // namespace

TEST_CASE("cameras at the limit of what is read are written as what is read, or not at all") {
  test::Random random(9);
  std::array<int, 2> counts{};
  for (int round = 0; round < 2000; ++round) {
    CameraList list = random_cameras(2, static_cast<std::uint64_t>(round));
    Eigen::Matrix3d& k = list.cameras[0].camera.intrinsics;
    k(1, 2) = 0;
    k(0, 2) = k(0, 0) * 1e12 * (1 + random.uniform(-1e-3, 1e-3));
    for (const CameraFormat format :
         {CameraFormat::middlebury, CameraFormat::colmap, CameraFormat::matrices,
          CameraFormat::transforms, CameraFormat::meshroom, CameraFormat::openmvs}) {
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

TEST_CASE("what is written reads back") {
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
  for (const CameraFormat format :
       {CameraFormat::transforms, CameraFormat::meshroom, CameraFormat::openmvs})
    CHECK(check_back(format, 1e-9).cameras[3].height == 480);
  const CameraList colmap = check_back(CameraFormat::colmap, 1e-9);
  CHECK(colmap.cameras[3].width == 640);
  CHECK(colmap.cameras[3].height == 480);
}

TEST_CASE("what a format cannot hold is refused") {
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
  list = random_cameras(2, 5);
  list.cameras[0].distortion.radial[3] = 0.1;
  for (const CameraFormat format : {CameraFormat::transforms, CameraFormat::meshroom})
    CHECK(refused(list, format, "k4"));
  CHECK(refused(list, CameraFormat::openmvs, "distortion"));
  list = random_cameras(2, 5);
  list.cameras[0].name = "\xff";
  for (const CameraFormat format : {CameraFormat::transforms, CameraFormat::meshroom})
    CHECK(refused(list, format, "UTF-8"));
}

TEST_CASE("files of a folder are what the format's programs expect") {
  const CameraList list = random_cameras(2, 5);
  const auto names = [&](CameraFormat format) {
    std::string found;
    for (const CameraText& file : write_camera_files(list, format)) found += file.name + ' ';
    return found;
  };
  CHECK(names(CameraFormat::middlebury) == "cameras_par.txt ");
  CHECK(names(CameraFormat::colmap) == "cameras.txt images.txt points3D.txt ");
  CHECK(names(CameraFormat::matrices) == "view0.txt view1.txt ");
  CHECK(names(CameraFormat::transforms) == "transforms.json ");
  CHECK(names(CameraFormat::meshroom) == "cameras.sfm ");
  CHECK(names(CameraFormat::openmvs) == "scene.mvs ");
}

TEST_CASE("matrices of a folder are each in a file of its own that is found there") {
  for (const char* name : {"left/view0.png", "view0.jpg", ".view1.png"}) {
    CameraList list = random_cameras(2, 5);
    list.cameras[1].name = name;
    CHECK_THROWS_AS(write_camera_files(list, CameraFormat::matrices), InputError);
    CHECK_NOTHROW(write_camera_files(list, CameraFormat::colmap));
  }
}

TEST_CASE("distortion and lenses of their own are written and read back") {
  for (const CameraFormat format : {CameraFormat::transforms, CameraFormat::meshroom}) {
    for (const bool is_shared : {false, true}) {
      CameraList list = random_cameras(3, 6);
      for (CameraRecord& record : list.cameras) {
        if (is_shared) record.camera.intrinsics = list.cameras[0].camera.intrinsics;
        record.distortion = {{0.1, -0.2, 0.05, 0, 0, 0}, {0.01, -0.02}};
      }
      list.cameras[1].distortion.tangential = {0, 0};
      const CameraList back = parse_cameras(write_cameras(list, format), "back.json");
      REQUIRE(back.cameras.size() == 3);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(back.cameras[i].distortion == list.cameras[i].distortion);
        CHECK(pixel_difference(list.cameras[i].camera, back.cameras[i].camera) < 1e-9);
      }
    }
  }
}
