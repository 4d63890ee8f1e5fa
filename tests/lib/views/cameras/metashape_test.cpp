#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "helpers/camera_texts.h"

using namespace transformesh;
using test::refusal;

namespace {

const std::string calibration =
    "<f>500</f><cx>2</cx><cy>-3</cy><b1>10</b1><b2>4</b2><k1>.1</k1><k2>.2</k2><k3>.3</k3>"
    "<p1>.01</p1><p2>.02</p2>";

std::string file(const std::string& numbers, const std::string& transform) {
  return "<?xml version=\"1.0\"?>\n<document version=\"1.5.0\"><chunk label=\"a\"><sensors>"
         "<sensor id=\"0\"><calibration type=\"frame\"><resolution width=\"640\" height='480'/>" +
         numbers +
         "</calibration></sensor></sensors><cameras>"
         "<camera id=\"0\" sensor_id=\"0\" label=\"a &amp; b\"><transform>" +
         transform + "</transform></camera></cameras></chunk></document>\n";
}

const std::string pose = "0 -1 0 5  1 0 0 6  0 0 1 7  0 0 0 1";

}  // namespace

TEST_CASE("Metashape: pixels are those of its manual's formulas") {
  const CameraList list = parse_cameras(file(calibration, pose), "cameras.xml");
  REQUIRE(list.cameras.size() == 1);
  const CameraRecord& record = list.cameras[0];
  CHECK(record.name == "a & b");
  CHECK(list.names_images);
  CHECK(record.width == 640);
  // A point in front of the camera, and its pixel in an image whose first pixel begins at 0, 0.
  const Vec3 local(0.3, -0.2, 2);
  Eigen::Matrix3d to_chunk;
  to_chunk << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Vec3 world = to_chunk * local + Vec3(5, 6, 7);
  const double x = local.x() / local.z();
  const double y = local.y() / local.z();
  const double r2 = x * x + y * y;
  const double radial = 1 + 0.1 * r2 + 0.2 * r2 * r2 + 0.3 * r2 * r2 * r2;
  const double bent_x = x * radial + 0.01 * (r2 + 2 * x * x) + 2 * 0.02 * x * y;
  const double bent_y = y * radial + 0.02 * (r2 + 2 * y * y) + 2 * 0.01 * x * y;
  const double u = 640 * 0.5 + 2 + bent_x * 500 + bent_x * 10 + bent_y * 4;
  const double v = 480 * 0.5 - 3 + bent_y * 500;

  const Vec3 seen = record.camera.rotation * world + record.camera.translation;
  const Eigen::Vector2d bent =
      record.distortion.distorted(seen.x() / seen.z(), seen.y() / seen.z());
  const Vec3 pixel = record.camera.intrinsics * bent.homogeneous();
  CHECK(pixel.x() + 0.5 == doctest::Approx(u).epsilon(1e-12));
  CHECK(pixel.y() + 0.5 == doctest::Approx(v).epsilon(1e-12));
}

TEST_CASE("Metashape: invalid cameras are refused") {
  const auto says = [](const std::string& text, const std::string& words) {
    const std::string message = refusal(text);
    INFO(message);
    return message.find(words) != std::string::npos;
  };
  CHECK(refusal(file(calibration, pose)).empty());
  CHECK(says(file("<f>0</f>", pose), "positive"));
  CHECK(says(file("<f>5x</f>", pose), "'5x'"));
  CHECK(says(file("<f>1 2</f>", pose), "not one number"));
  CHECK(says(file(calibration, "1 0 0"), "does not have 16 numbers"));
  CHECK(says(file(calibration, "1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1"), "no rotation"));
  CHECK(says(file(calibration + "<p3>1</p3>", pose), "p3"));
  const std::string whole = file(calibration, pose);
  const std::size_t end_of_chunk = whole.find("</chunk");
  for (std::size_t size = whole.find("<chunk") + 6; size < end_of_chunk; ++size)
    CHECK_THROWS_AS(parse_cameras(whole.substr(0, size), "cut.xml"), InputError);
}
