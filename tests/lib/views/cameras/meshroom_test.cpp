#include "helpers/camera_pixels.h"

using namespace transformesh;
using test::refuses;

namespace {

/// Returns the numbers of a matrix as Meshroom writes them: as texts, column by column.
std::string texts(const Eigen::MatrixXd& matrix) {
  return "[\"" + test::joined(matrix, "\",\"") + "\"]";
}

std::string file(const std::string& revision, const std::string& lens) {
  const test::TruePose pose;
  return R"({"version":["1","2",")" + revision + R"("],"views":[
    {"viewId":"7","poseId":"7","intrinsicId":"3","path":"C:\\photos\\a.jpg","width":"640","height":"480"},
    {"viewId":"8","poseId":"8","intrinsicId":"3","path":"C:\\photos\\unplaced.jpg"}],
    "intrinsics":[{"intrinsicId":"3","width":"640","height":"480",)" +
         lens + R"(}],"poses":[{"poseId":"7","pose":{"transform":{"rotation":)" +
         texts(pose.rotation.transpose()) + R"(,"center":)" + texts(pose.center.transpose()) +
         "}}}]}";
}

CameraRecord read(const std::string& revision, const std::string& lens) {
  const CameraList list = parse_cameras(file(revision, lens), "cameras.sfm");
  REQUIRE(list.cameras.size() == 1);
  CHECK(list.cameras[0].name == "a.jpg");
  CHECK(list.cameras[0].height == 480);
  return list.cameras[0];
}

const std::string radial =
    R"("type":"radial3","distortionParams":["0.1","-0.05","0.02"],"principalPoint":)";

}  // namespace

TEST_CASE("Meshroom: pixels of every version of the file") {
  const auto expected = [](double x, double y) {
    const double r2 = x * x + y * y;
    const double radius = 1 + 0.1 * r2 - 0.05 * r2 * r2 + 0.02 * r2 * r2 * r2;
    return Eigen::Vector2d(500 * radius * x + 322, 250 * radius * y + 235);
  };
  test::check_pixels(read("0", R"("pxFocalLength":["500","250"],)" + radial + R"(["322","235"])"),
                     expected);
  test::check_pixels(read("1", R"("pxFocalLength":["500","250"],)" + radial + R"(["2","-5"])"),
                     expected);
  // The focal length is 28.125 mm on a sensor that is 36 mm wide. Revision 5 inverted `pixelRatio`.
  const std::string mm = R"("sensorWidth":"36","focalLength":"28.125","pixelRatio":)";
  test::check_pixels(read("4", mm + R"("2",)" + radial + R"(["2","-5"])"), expected);
  test::check_pixels(read("5", mm + R"("0.5",)" + radial + R"(["2","-5"])"), expected);
}

TEST_CASE("Meshroom: Brown's distortion, and a type of its own") {
  const auto expected = [](double x, double y) {
    const double r2 = x * x + y * y;
    return Eigen::Vector2d(
        500 * (x * (1 + 0.1 * r2) + 2 * 0.01 * x * y - 0.02 * (r2 + 2 * x * x)) + 320,
        500 * (y * (1 + 0.1 * r2) + 0.01 * (r2 + 2 * y * y) - 2 * 0.02 * x * y) + 240);
  };
  const std::string lens =
      R"("pxFocalLength":["500","500"],"principalPoint":["0","0"],"distortionParams":["0.1","0","0","0.01","-0.02"],)";
  test::check_pixels(read("1", lens + R"("type":"brown")"), expected);
  test::check_pixels(read("1", lens + R"("type":"pinhole","distortionType":"brown")"), expected);
}

TEST_CASE("Meshroom: what is no camera is refused with its entry") {
  const std::string focal = R"("pxFocalLength":["500","500"],)";
  CHECK(refuses(file("1", radial + R"(["0","0"])"), "intrinsics[0] has no pxFocalLength"));
  CHECK(refuses(file("1", focal + radial + R"(["0"])"), "principalPoint has 1 elements"));
  CHECK(refuses(file("1", focal + radial + R"(["0","nan"])"), "principalPoint[1]"));
  CHECK(refuses(file("1", focal + R"("type":"fisheye4","principalPoint":["0","0"])"), "fisheye4"));
  CHECK(refuses(file("x", focal + radial + R"(["0","0"])"), "version[2]"));
  CHECK(refuses(R"({"version":["2","0","0"],"views":[{"viewId":1}]})", "version is not 1"));
  CHECK(refuses(R"({"version":["1","0","0"],"views":[{"viewId":1}]})", "no poses"));
  CHECK(refuses(R"({"version":["1","0","0"],"views":[{"viewId":1}],"intrinsics":[],"poses":""})",
                "no view"));
  test::check_damaged(file("1", focal + radial + R"(["0","0"])"));
}
