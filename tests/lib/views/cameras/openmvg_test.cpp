#include "helpers/camera_pixels.h"

using namespace transformesh;
using test::refuses;

namespace {

const std::string wrapped = R"("value":{"polymorphic_id":1,"ptr_wrapper":{"id":2,"data":)";

std::string file(const std::string& lens) {
  const test::TruePose pose;
  std::string rotation;
  for (int i = 0; i < 3; ++i) {
    rotation += i == 0 ? "[[" : ",[";
    rotation += test::joined(pose.rotation.row(i), ",") + "]";
  }
  const auto view = [](int id, const std::string& name) {
    const std::string number = std::to_string(id);
    return R"({"key":)" + number + "," + wrapped + R"({"local_path":"left","filename":")" + name +
           R"(","width":640,"height":480,"id_view":)" + number + R"(,"id_intrinsic":0,"id_pose":)" +
           number + "}}}}";
  };
  return R"({"sfm_data_version":"0.3","root_path":"/x","views":[)" + view(0, "a.jpg") + "," +
         view(1, "unplaced.jpg") + R"(],"intrinsics":[{"key":0,)" + wrapped + lens +
         R"(}}}],"extrinsics":[{"key":0,"value":{"rotation":)" + rotation + R"(],"center":[)" +
         test::joined(pose.center.transpose(), ",") +
         R"(]}}],"structure":[{"key":0}],"control_points":[]})";
}

CameraRecord read(const std::string& lens) {
  const CameraList list = parse_cameras(file(lens), "sfm_data.json");
  REQUIRE(list.cameras.size() == 1);
  CHECK(list.cameras[0].name == "left/a.jpg");
  CHECK(list.cameras[0].width == 640);
  return list.cameras[0];
}

const std::string pinhole =
    R"("width":640,"height":480,"focal_length":500,"principal_point":[322,235])";

}  // namespace

TEST_CASE("OpenMVG: pixels of every lens, with the pinhole's parameters inside or apart") {
  const auto expected = [](double k1, double k3, double t) {
    return [k1, k3, t](double x, double y) {
      const double r2 = x * x + y * y;
      const double radial = 1 + k1 * r2 + k3 * r2 * r2 * r2;
      return Eigen::Vector2d(500 * (x * radial + 2 * t * x * y - t * (r2 + 2 * x * x)) + 322,
                             500 * (y * radial + t * (r2 + 2 * y * y) - 2 * t * x * y) + 235);
    };
  };
  test::check_pixels(read("{" + pinhole + "}"), expected(0, 0, 0));
  test::check_pixels(read("{" + pinhole + R"(,"disto_k1":[0.1]})"), expected(0.1, 0, 0));
  test::check_pixels(read(R"({"value0":{)" + pinhole + R"(},"disto_k3":[0.1,0,0.2]})"),
                     expected(0.1, 0.2, 0));
  test::check_pixels(read(R"({"value0":{)" + pinhole + R"(},"disto_t2":[0.1,0,0.2,0.01,-0.01]})"),
                     expected(0.1, 0.2, 0.01));
}

TEST_CASE("OpenMVG: what is no camera is refused with its entry") {
  CHECK(refuses(file(R"({"width":4,"height":4})"), "focal_length"));
  CHECK(refuses(file("{" + pinhole + R"(,"fisheye":[0,0,0,0]})"), "data.fisheye"));
  CHECK(refuses(file("{" + pinhole + R"(,"disto_k3":[0,0]})"), "disto_k3 has 2 elements"));
  CHECK(refuses(file("5"), "intrinsics[0].value.ptr_wrapper.data is not an object"));
  CHECK(refuses(R"({"sfm_data_version":"0.3","views":[],"intrinsics":[],"extrinsics":[]})",
                "no view"));
  CHECK(refuses(R"({"sfm_data_version":"0.3","views":{}})", "has no intrinsics"));
  test::check_damaged(file("{" + pinhole + "}"));
}
