#include "helpers/camera_pixels.h"

using namespace transformesh;
using test::refuses;

namespace {

/// Columns of the matrix are the axes right, up and backwards, and the center.
std::string matrix() {
  const test::TruePose pose;
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() << pose.rotation.row(0).transpose(), -pose.rotation.row(1).transpose(),
      -pose.rotation.row(2).transpose();
  m.topRightCorner<3, 1>() = pose.center;
  std::string text;
  for (int i = 0; i < 4; ++i) {
    text += i == 0 ? "[[" : ",[";
    text += test::joined(m.row(i), ", ") + "]";
  }
  return text + "]";
}

std::string file(const std::string& shared, const std::string& own) {
  return "{" + shared + R"("frames": [{"file_path": "./images/a.png",)" + own +
         R"("transform_matrix":)" + matrix() + "}]}";
}

CameraRecord read(const std::string& shared, const std::string& own = "") {
  const CameraList list = parse_cameras(file(shared, own), "transforms.json");
  CHECK(list.names_images);
  REQUIRE(list.cameras.size() == 1);
  CHECK(list.cameras[0].name == "images/a.png");
  return list.cameras[0];
}

}  // namespace

TEST_CASE("transforms.json: pixels are those of OpenCV's model, counted from the image's corner") {
  const std::string lens =
      R"("camera_model":"OPENCV","w":640,"h":480,"fl_x":500,"fl_y":510,"cx":322,"cy":235,
         "k1":0.1,"k2":-0.05,"k3":0.02,"k4":0,"p1":0.01,"p2":-0.02,)";
  const auto expected = [](double x, double y) {
    const double r2 = x * x + y * y;
    const double radial = 1 + 0.1 * r2 - 0.05 * r2 * r2 + 0.02 * r2 * r2 * r2;
    const double u = x * radial + 2 * 0.01 * x * y - 0.02 * (r2 + 2 * x * x);
    const double v = y * radial + 0.01 * (r2 + 2 * y * y) - 2 * 0.02 * x * y;
    return Eigen::Vector2d(500 * u + 322 - 0.5, 510 * v + 235 - 0.5);
  };
  test::check_pixels(read(lens), expected);
  // Numbers of a frame take precedence over those of the file.
  test::check_pixels(read(R"("fl_x":1,"cx":7,"k1":9,)", lens), expected);
  CHECK(read(lens).width == 640);
}

TEST_CASE("transforms.json: an angle of view is that of the image's width") {
  const auto expected = [](double x, double y) {
    const double focal = 320 / std::tan(0.4);
    return Eigen::Vector2d(focal * x + 319.5, focal * y + 239.5);
  };
  test::check_pixels(read(R"("camera_angle_x":0.8,"w":640,"h":480,)"), expected);
  // NeRF's files do not state the size of the images.
  CameraRecord record = read(R"("camera_angle_x":0.8,)");
  record.set_size(640, 480, "a.png");
  test::check_pixels(record, expected);
  record = read(R"("camera_angle_x":0.8,)");
  record.set_size(480, 640, "a.png");
  CHECK(record.camera.intrinsics(0, 0) == doctest::Approx(240 / std::tan(0.4)));
}

TEST_CASE("transforms.json: what is no camera is refused with its entry") {
  const std::string lens = R"("w":640,"h":480,"fl_x":500,)";
  CHECK(refuses(file("", ""), "frames[0] has neither fl_x nor camera_angle_x"));
  CHECK(refuses(file(R"("fl_x":"a",)", ""), "fl_x is not a finite number"));
  CHECK(refuses(file(R"("fl_x":-5,)", ""), "positive"));
  CHECK(refuses(file(R"("fl_x":1e999,)", ""), "malformed"));
  CHECK(refuses(file(R"("fl_x":NaN,)", ""), "malformed"));
  CHECK(refuses(file(R"("camera_angle_x":4,)", ""), "between 0 and pi"));
  CHECK(refuses(file(R"("camera_angle_x":1,"cx":4,"cy":4,)", ""), "w and h"));
  CHECK(refuses(file(lens, R"("camera_model":"OPENCV_FISHEYE",)"), "frames[0].camera_model"));
  CHECK(refuses(file(lens + R"("is_fisheye":true,)", ""), "undistort"));
  CHECK(refuses(file(lens, R"("k4":1,)"), "frames[0].k4"));
  CHECK(refuses(file(lens, R"("w":1e12,)"), "frames[0].w"));
  CHECK(refuses(R"({"fl_x":5,"frames":[]})", "no frame"));
  CHECK(refuses(R"({"fl_x":5,"frames":5})", "frames is not a list"));
  CHECK(refuses(R"({"fl_x":5,"frames":[{"file_path":"a","transform_matrix":[[1,2,3]]}]})",
                "3 or 4 rows"));
  CHECK(refuses(R"({"fl_x":5,"frames":[{"file_path":"a","transform_matrix":
                [[1,0,0,0],[0,1,0,0],[0,0,2,0]]}]})",
                "frames[0].transform_matrix"));
  test::check_damaged(file(lens, ""));
}
