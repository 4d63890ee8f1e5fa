#include <doctest/doctest.h>

#include "helpers/camera_texts.h"

using namespace transformesh;
using test::refusal;

namespace {

std::string yaml(const std::string& rest) {
  return "%YAML:1.0\n---\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   "
         "data: "
         "[ 300., 0.,\n       160., 0., 310.,  120., 0., 0., 1. ]\n" +
         rest;
}

bool says(const std::string& text, const std::string& words) {
  const std::string message = refusal(text);
  INFO(message);
  return message.find(words) != std::string::npos;
}

const std::string pose = "R: [ 1, 0, 0, 0, 1, 0, 0, 0, 1 ]\nT: [ 1, 2, 3 ]\n";

}  // namespace

TEST_CASE("OpenCV: rows of rotation vectors and translations are a camera each") {
  const CameraList list = parse_cameras(
      yaml("image_width: 320\nimage_height: 240\ndistortion_coefficients: [ .1, .2, .3, .4, .5 ]\n"
           "extrinsic_parameters: !!opencv-matrix\n   rows: 2\n   cols: 6\n   dt: d\n"
           "   data: [ 0, 0, 1.5707963267948966, 1, 2, 3,\n 0, 0, 0, 4, 5, 6 ]\n"),
      "calibration.yml");
  REQUIRE(list.cameras.size() == 2);
  const CameraRecord& first = list.cameras[0];
  CHECK(first.name == "calibration-1");
  CHECK(first.width == 320);
  CHECK(first.height == 240);
  CHECK(first.camera.intrinsics(1, 1) == 310);
  CHECK(first.camera.intrinsics(1, 2) == 120);
  CHECK((first.camera.rotation * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm() < 1e-15);
  CHECK(first.camera.translation == Vec3(1, 2, 3));
  CHECK(first.distortion.radial[2] == 0.5);
  CHECK(first.distortion.tangential[1] == 0.4);
  CHECK(list.cameras[1].camera.rotation == Eigen::Matrix3d::Identity());
}

TEST_CASE("OpenCV: invalid cameras are refused") {
  CHECK(refusal(yaml(pose)).empty());
  CHECK(says(yaml(""), "no R"));
  CHECK(says(yaml("R: [ 1, 0, 0, 0, 1, 0, 0, 0, -1 ]\nT: [ 1, 2, 3 ]\n"), "not a rotation"));
  CHECK(says(yaml("R: [ 1, 0, 0 ]\nT: [ 1, 2 ]\n"), "must have 9"));
  CHECK(says(yaml("R: [ 1, 0, .Nan ]\nT: [ 1, 2, 3 ]\n"), "'.Nan'"));
  CHECK(says(yaml("extrinsic_parameters: [ 1, 2, 3 ]\n"), "rows of 6"));
  CHECK(says(yaml(pose + "D: [ 0, 0, 0, 0, 0, 0, 0, 0, 1 ]\n"), "undistort"));
  CHECK(says("%YAML:1.0\n---\n" + pose, "no camera_matrix"));
  CHECK(says("%YAML:1.0\n---\nK: [ 1, 0, 0, 0, -1, 0, 0, 0, 1 ]\n" + pose, "positive"));
  const std::string whole = yaml(pose);
  for (std::size_t size = 5; size < whole.size() - 3; ++size)
    CHECK_THROWS_AS(parse_cameras(whole.substr(0, size), "cut.yml"), InputError);
}

TEST_CASE("OpenCV: several cameras in a file, by numbered entries or by 3x4 matrices") {
  const auto matrix = [](const std::string& name, const std::string& numbers) {
    return "<" + name + " type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt><data>" +
           numbers + "</data></" + name + ">\n";
  };
  const std::string start = "<?xml version=\"1.0\"?>\n<opencv_storage>\n";
  const std::string end = "</opencv_storage>\n";
  std::string text = start + "<image_width>320</image_width><image_height>240</image_height>\n";
  for (const std::string i : {"_1", "_2"})
    text += matrix("K" + i, "30" + i.substr(1) + " 0 160 0 310 120 0 0 1") +
            matrix("R" + i, "1 0 0 0 1 0 0 0 1") + matrix("T" + i, "0 0 " + i.substr(1));
  const CameraList numbered = parse_cameras(text + end, "rig.xml");
  REQUIRE(numbered.cameras.size() == 2);
  CHECK(numbered.cameras[1].name == "rig-2");
  CHECK(numbered.cameras[1].width == 320);
  CHECK(numbered.cameras[1].camera.intrinsics(0, 0) == 302);
  CHECK(numbered.cameras[1].camera.translation == Vec3(0, 0, 2));

  const std::string projections = matrix("left", "300 0 160 0 0 310 120 0 0 0 1 5") +
                                  matrix("Q", "1 2 3 4") +
                                  matrix("right", "300 0 160 -30 0 310 120 0 0 0 1 5");
  const CameraList list = parse_cameras(start + projections + end, "rig.xml");
  REQUIRE(list.cameras.size() == 2);
  CHECK(list.cameras[1].name == "right");
  CHECK(list.cameras[1].camera.intrinsics(1, 1) == doctest::Approx(310));
  CHECK(list.cameras[1].camera.translation.x() == doctest::Approx(-160 * 5 / 300.0 - 0.1));

  CHECK(says(start + matrix("P", "0 0 0 0 0 0 0 0 0 0 0 0") + end, "P is singular"));
  CHECK(says(start + matrix("K0", "300 0 160 0 310 120 0 0 1") + end, "no R0"));
  std::string many = start;
  for (int i = 0; i < 1001; ++i) many += matrix(std::string("m").append(std::to_string(i)), "1");
  CHECK(says(many + end, "more than 1000 matrices"));
}
