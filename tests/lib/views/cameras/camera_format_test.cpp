#include "views/cameras/camera_format.h"

#include <doctest/doctest.h>

#include "helpers/camera_texts.h"

using namespace transformesh;
using test::refusal;

TEST_CASE("formats are distinguished by their content") {
  CHECK(camera_format("16\na.png 1") == CameraFormat::middlebury);
  CHECK(camera_format("# Camera list\n1 PINHOLE 3 4 5") == CameraFormat::colmap);
  CHECK(camera_format("1 1 0 0 0 0 0 5 1 a.png") == CameraFormat::colmap);
  CHECK(camera_format("# Bundle file v0.3\n") == CameraFormat::bundler);
  CHECK(camera_format("1 2 3 4\n") == CameraFormat::matrices);
  CHECK(camera_format("CONTOUR\n") == CameraFormat::matrices);
  CHECK(camera_format("{\"fl_x\": 5, \"frames\": []}") == CameraFormat::transforms);
  CHECK(camera_format("{\"sfm_data_version\": \"0.3\"}") == CameraFormat::openmvg);
  CHECK(camera_format(" {\"version\": [\"1\"], \"views\": [{\"viewId\"") == CameraFormat::meshroom);
  CHECK(camera_format("extrinsic\n1 0 0 0\n") == CameraFormat::mvsnet);
  CHECK(camera_format("\x93NUMPY\x01") == CameraFormat::llff);
  CHECK(camera_format("PK\x03\x04") == CameraFormat::neus);
  CHECK(camera_format("NVM_V3 \n") == CameraFormat::nvm);
  CHECK(camera_format("# MVE\n[camera]\nfocal_length = 1") == CameraFormat::mve);
  CHECK(camera_format(std::string_view("MVSI\x07\0", 6)) == CameraFormat::openmvs);
  // A project of Meshroom, and other JSON.
  CHECK_FALSE(camera_format("{\"nodeType\": 1, \"viewId\": 2}").has_value());
  CHECK_FALSE(camera_format("{\"asset\": 1}").has_value());
  for (const char* other : {"", "OFF\n3 1 0\n", "hello", "ply\nformat", "12 34 name.png\n",
                            "The OBJECT is 3", "1 2 3\n", "name.png\n"}) {
    CAPTURE(other);
    CHECK_FALSE(camera_format(other).has_value());
  }
  CHECK_FALSE(camera_format(std::string_view("1\n\0", 3)).has_value());
  CHECK(refusal("").find("empty") != std::string::npos);
  CHECK(refusal("OFF\n3 1 0\n").find("'OFF") != std::string::npos);
}
