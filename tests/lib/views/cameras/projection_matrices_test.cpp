// Cameras from projection matrices: the product of their parts is the matrix, up to a factor.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <sstream>

#include "raster/camera.h"
#include "transformesh/errors.h"
#include "transformesh/pinhole_camera.h"
#include "views/cameras/camera_file.h"

using namespace transformesh;

namespace {

Projection projection_of(double focal, double skew, const Vec3& axis, const Vec3& center) {
  Eigen::Matrix3d intrinsics;
  intrinsics << focal, skew, 160, 0, 1.1 * focal, 120, 0, 0, 1;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(1.1, axis.normalized()).matrix();
  Projection projection;
  projection << rotation, -rotation * center;
  return intrinsics * projection;
}

std::string text_of(const Projection& projection) {
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) text << projection(i, j) << (j == 3 ? '\n' : ' ');
  return text.str();
}

PinholeCamera read(const Projection& projection) {
  const CameraList list = parse_cameras("CONTOUR\n" + text_of(projection), "a.txt");
  REQUIRE(list.cameras.size() == 1);
  return list.cameras[0].camera;
}

}  // namespace

TEST_CASE("intrinsics, rotation and center come back, whatever the factor and its sign") {
  const Vec3 center(3, -2, 5);
  for (const double skew : {0.0, 7.0}) {
    const Projection projection = projection_of(400, skew, {1, 2, 3}, center);
    for (const double factor : {1.0, -1.0, 1e-5, -300.0}) {
      const PinholeCamera camera = read(factor * projection);
      CHECK(camera.intrinsics(0, 0) == doctest::Approx(400));
      CHECK(camera.intrinsics(1, 1) == doctest::Approx(440));
      CHECK(camera.intrinsics(0, 1) == doctest::Approx(skew).epsilon(1e-6));
      CHECK(camera.rotation.determinant() == doctest::Approx(1));
      CHECK((camera.rotation.transpose() * camera.translation + center).norm() < 1e-9);
      const Projection again = camera.projection();
      CHECK((again - projection).norm() < 1e-9 * projection.norm());
    }
  }
}

TEST_CASE("a matrix without a center, or with a word in it, is refused") {
  Projection flat = projection_of(400, 0, {1, 2, 3}, {1, 1, 1});
  flat.col(0) = flat.col(1);
  CHECK_THROWS_AS(parse_cameras("CONTOUR\n" + text_of(flat), "a.txt"), InputError);
  CHECK_THROWS_AS(parse_cameras("CONTOUR\n1 2 3 4\n5 6 seven 8\n9 1 2 3\n", "a.txt"), InputError);
  CHECK_THROWS_AS(parse_cameras("CONTOUR\n1 2 3 4\n5 6 7 8\n", "a.txt"), InputError);
}
