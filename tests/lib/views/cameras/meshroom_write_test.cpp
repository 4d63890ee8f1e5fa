#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "helpers/random_cameras.h"
#include "views/cameras/camera_formats.h"

using namespace transformesh;

TEST_CASE("Meshroom: lenses are shared, numbers are text, and rotations are written by columns") {
  CameraList list = test::random_cameras(3, 6);
  list.cameras[2].camera.intrinsics = list.cameras[0].camera.intrinsics;
  list.cameras[1].distortion.radial[0] = 0.25;
  const auto json = nlohmann::json::parse(write_meshroom(list));
  CHECK(json["version"] == nlohmann::json({"1", "2", "0"}));
  REQUIRE(json["intrinsics"].size() == 2);
  CHECK(json["intrinsics"][0]["type"] == "pinhole");
  CHECK(json["intrinsics"][1]["type"] == "radial3");
  CHECK(json["intrinsics"][1]["distortionParams"] == nlohmann::json({"0.25", "0", "0"}));
  CHECK(json["views"][2]["intrinsicId"] == "0");
  const auto number = [](const nlohmann::json& text) { return std::stod(text.get<std::string>()); };
  const auto& transform = json["poses"][1]["pose"]["transform"];
  const PinholeCamera& camera = list.cameras[1].camera;
  CHECK(number(transform["rotation"][1]) == camera.rotation(1, 0));
  CHECK(number(transform["rotation"][3]) == camera.rotation(0, 1));
  CHECK(number(transform["center"][2]) == camera.center().z());
}
