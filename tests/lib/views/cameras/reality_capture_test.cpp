#include <doctest/doctest.h>

#include "helpers/camera_texts.h"

using namespace transformesh;
using test::refusal;

namespace {

const std::string header = "#name,x,y,alt,heading,pitch,roll,f,px,py,k1,k2,k3,k4,t1,t2\n";

PinholeCamera camera_at(const std::string& angles) {
  CameraList list =
      parse_cameras(header + "a.jpg,1,2,3," + angles + ",36,0.01,-0.02,0,0,0,0,0,0\n", "c.csv");
  REQUIRE(list.cameras.size() == 1);
  list.cameras[0].set_size(400, 300, "a.jpg");
  return list.cameras[0].camera;
}

bool is_near(const Vec3& first, const Vec3& second) { return (first - second).norm() < 1e-12; }

std::string xmp(const std::string& attributes, const std::string& elements) {
  return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF><rdf:Description "
         "xcr:FocalLength35mm=\"72\" " +
         attributes + ">" + elements + "</rdf:Description></rdf:RDF></x:xmpmeta>";
}

const std::string pose =
    "<xcr:Rotation>0 -1 0 1 0 0 0 0 1</xcr:Rotation><xcr:Position>1 2 3</xcr:Position>";

}  // namespace

TEST_CASE("RealityCapture: without angles a camera points down; angles rotate it as on a map") {
  const PinholeCamera down = camera_at("0,0,0");
  CHECK(is_near(down.center(), Vec3(1, 2, 3)));
  CHECK(is_near(down.rotation.row(2).transpose(), -Vec3::UnitZ()));
  CHECK(is_near(down.rotation.row(1).transpose(), -Vec3::UnitY()));
  // The principal point is counted from the center, in widths.
  CHECK(down.intrinsics(0, 0) == 400);
  CHECK(down.intrinsics(1, 1) == 400);
  CHECK(down.intrinsics(0, 2) == doctest::Approx(199.5 + 4));
  CHECK(down.intrinsics(1, 2) == doctest::Approx(149.5 - 8));
  // Pitched up to the horizon the camera looks north; a heading of 90 degrees is east, and a roll
  // leans it to the right.
  CHECK(is_near(camera_at("0,90,0").rotation.row(2).transpose(), Vec3::UnitY()));
  const PinholeCamera east = camera_at("90,90,0");
  CHECK(is_near(east.rotation.row(2).transpose(), Vec3::UnitX()));
  CHECK(is_near(east.rotation.row(1).transpose(), -Vec3::UnitZ()));
  CHECK(is_near(camera_at("0,0,90").rotation.row(2).transpose(), -Vec3::UnitX()));
}

TEST_CASE("RealityCapture: an XMP file is a camera, by attributes or elements") {
  for (const bool is_attribute : {true, false}) {
    const std::string coefficients = ".1 .2 .3 0 .4 .5";
    const std::string attribute = "xcr:DistortionCoeficients=\"" + coefficients + "\"";
    const std::string element =
        "<xcr:DistortionCoeficients>" + coefficients + "</xcr:DistortionCoeficients>";
    CameraList list = parse_cameras(
        xmp("xcr:DistortionModel=\"brown3t2\" xcr:AspectRatio=\"1.1\" xcr:PrincipalPointU=\".1\" " +
                (is_attribute ? attribute : ""),
            pose + (is_attribute ? "" : element)),
        "folder/IMG_1.xmp");
    REQUIRE(list.cameras.size() == 1);
    CameraRecord& record = list.cameras[0];
    CHECK(record.name == "IMG_1");
    record.set_size(300, 400, "IMG_1.jpg");
    CHECK(record.camera.intrinsics(0, 0) == doctest::Approx(800));
    CHECK(record.camera.intrinsics(1, 1) == doctest::Approx(880));
    CHECK(record.camera.intrinsics(0, 2) == doctest::Approx(149.5 + 40));
    CHECK(is_near(record.camera.center(), Vec3(1, 2, 3)));
    CHECK(record.camera.rotation(1, 0) == 1);
    CHECK(record.distortion.radial[2] == 0.3);
    CHECK(record.distortion.tangential[0] == 0.4);
  }
}

TEST_CASE("RealityCapture: invalid cameras are refused") {
  const auto says = [](const std::string& text, const std::string& words) {
    const std::string message = refusal(text);
    INFO(message);
    return message.find(words) != std::string::npos;
  };
  CHECK(refusal(xmp("", pose)).empty());
  CHECK(says(xmp("", ""), "xcr:Rotation"));
  CHECK(says(xmp("xcr:Skew=\"a\"", pose), "'a'"));
  CHECK(says(xmp("xcr:DistortionModel=\"brown4\"",
                 pose + "<xcr:DistortionCoeficients>0 0 0 1 0 0</xcr:DistortionCoeficients>"),
             "k4"));
  CHECK(says(header, "no camera"));
  CHECK(says(header + "a,1\n", "2 fields, not 16"));
  CHECK(says("#name,x\na,1\n", "no column f"));
}
