#include "helpers/camera_pixels.h"
#include "helpers/temporary_folder.h"

using namespace transformesh;
using test::refuses;

namespace {

std::string file(const std::string& lens) {
  const test::TruePose pose;
  return "# MVE view meta data is stored in INI-file syntax.\n\n[camera]\n" + lens +
         "rotation = " + test::joined(pose.rotation, " ") +
         "\ntranslation = " + test::joined(pose.translation().transpose(), " ") +
         "\n\n[view]\nid = 0\nname = DSC1\n";
}

}  // namespace

TEST_CASE("MVE: pixels of fractions of the image's larger side") {
  CameraList list =
      parse_cameras(file("focal_length = 0.78125\npixel_aspect = 1\nprincipal_point = 0.5 0.5\n"),
                    "v.mve/meta.ini");
  REQUIRE(list.cameras.size() == 1);
  CHECK(list.cameras[0].name == "v.mve/undistorted");
  list.cameras[0].set_size(640, 480, "a.png");
  test::check_pixels(list.cameras[0], [](double x, double y) {
    return Eigen::Vector2d(500 * x + 319.5, 500 * y + 239.5);
  });
}

TEST_CASE("MVE: a scene is read by its views, with the sizes of their images") {
  const test::TemporaryFolder folder;
  const std::string image = "P5 64 48 255\n" + std::string(64 * 48, 'x');
  for (const std::string name : {"view_0000.mve", "view_0001.mve", "view_0002.mve"}) {
    std::filesystem::create_directories(folder / ("views/" + name));
    const bool is_placed = name != "view_0001.mve";
    test::make_file(folder / ("views/" + name + "/meta.ini"),
                    file(is_placed ? "focal_length = 0.78125\nprincipal_point = 0.6 0.5\n"
                                   : "focal_length = 0\n"));
    if (is_placed) test::make_file(folder / ("views/" + name + "/undistorted.png"), image);
  }
  for (const char* where : {"", "views"}) {
    const CameraList list = cameras_from(folder / where);
    REQUIRE(list.cameras.size() == 2);
    CHECK(list.cameras[1].name == "view_0002.mve/undistorted");
    CHECK(list.cameras[1].camera.intrinsics(0, 0) == doctest::Approx(50));
    CHECK(list.cameras[1].camera.intrinsics(0, 2) == doctest::Approx(0.6 * 64 - 0.5));
    CHECK(list.cameras[1].height == 48);
  }
}

TEST_CASE("MVE: what is no camera is refused") {
  CHECK(refuses(file("focal_length = -1\n"), "positive"));
  CHECK(refuses(file("focal_length = 0\n"), "no view has a pose"));
  CHECK(refuses(file("focal_length = x\n"), "focal_length"));
  CHECK(refuses(file("focal_length = 1\nprincipal_point = 0.6 0.5\n"), "principal_point"));
  CHECK(refuses(file("focal_length = 1\npixel_aspect = 2\n"), "pixel_aspect"));
  CHECK(refuses("[camera]\nfocal_length = 1\nrotation = 1 0 0\n", "3 numbers instead of 9"));
  test::check_damaged(file("focal_length = 1\n"));
}
