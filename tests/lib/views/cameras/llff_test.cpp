#include "helpers/camera_pixels.h"
#include "helpers/numpy_files.h"

using namespace transformesh;
using test::refuses;

namespace {

/// Returns a row: a 3x5 matrix and two depths. Columns of the matrix are the camera's axes down,
/// right and backwards, the center, and height, width and focal length.
std::vector<double> row(double focal) {
  const test::TruePose pose;
  Eigen::Matrix<double, 3, 5> m;
  m << pose.rotation.row(1).transpose(), pose.rotation.row(0).transpose(),
      -pose.rotation.row(2).transpose(), pose.center, Vec3(480, 640, focal);
  std::vector<double> numbers;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 5; ++j) numbers.push_back(m(i, j));
  numbers.insert(numbers.end(), {1.5, 20});
  return numbers;
}

std::string file(std::vector<double> numbers) {
  const std::string rows = std::to_string(numbers.size() / 17);
  return test::npy("<f8", std::string("(").append(rows).append(", 17)"),
                   test::bytes_of<double>(numbers));
}

}  // namespace

TEST_CASE("LLFF: pixels around the image's center") {
  std::vector<double> numbers = row(500);
  const std::vector<double> second = row(700);
  numbers.insert(numbers.end(), second.begin(), second.end());
  const CameraList list = parse_cameras(file(numbers), "poses_bounds.npy");
  REQUIRE(list.cameras.size() == 2);
  CHECK_FALSE(list.names_images);
  CHECK(list.cameras[0].name == "poses_bounds-1");
  CHECK(list.cameras[0].width == 640);
  test::check_pixels(list.cameras[0], [](double x, double y) {
    return Eigen::Vector2d(500 * x + 319.5, 500 * y + 239.5);
  });
  CHECK(list.cameras[1].camera.intrinsics(1, 1) == 700);
}

TEST_CASE("LLFF: what is no camera is refused with its row") {
  std::vector<double> numbers = row(500);
  numbers[4] = 0;
  CHECK(refuses(file(numbers), "height of row 1"));
  CHECK(refuses(file(row(-1)), "focal lengths of row 1"));
  numbers = row(500);
  numbers[2] *= 2;
  CHECK(refuses(file(numbers), "rotation of row 1"));
  CHECK(refuses(test::npy("<f8", "(17,)", test::bytes_of<double>(row(500))), "17 numbers"));
  CHECK(refuses(test::npy("<f8", "(0, 17)", ""), "no camera"));
  test::check_damaged(file(row(500)));
}
