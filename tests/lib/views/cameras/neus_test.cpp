#include "helpers/camera_pixels.h"
#include "helpers/numpy_files.h"
#include "io/streams/zip_archive.h"

using namespace transformesh;
using test::refuses;

namespace {

std::vector<double> matrix() {
  const test::TruePose pose;
  Eigen::Matrix3d k;
  k << 500, 0, 322, 0, 510, 235, 0, 0, 1;
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = 2.5 * k * pose.rotation;
  m.topRightCorner<3, 1>() = 2.5 * k * pose.translation();
  std::vector<double> numbers;
  for (int i = 0; i < 16; ++i) numbers.push_back(m(i / 4, i % 4));
  return numbers;
}

std::string file(const std::vector<std::string>& arrays) {
  ZipWriter archive;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    archive.add("world_mat_" + std::to_string(i) + ".npy", arrays[i]);
    archive.add("scale_mat_" + std::to_string(i) + ".npy", arrays[i]);
  }
  return archive.finish();
}

}  // namespace

TEST_CASE("NeuS: pixels of the matrices from the world, of any scale") {
  const std::string array = test::npy("<f8", "(4, 4)", test::bytes_of<double>(matrix()));
  const CameraList list = parse_cameras(file({array, array, array}), "cameras_sphere.npz");
  REQUIRE(list.cameras.size() == 3);
  CHECK_FALSE(list.names_images);
  CHECK(list.cameras[2].name == "cameras_sphere-3");
  test::check_pixels(list.cameras[0], [](double x, double y) {
    return Eigen::Vector2d(500 * x + 322, 510 * y + 235);
  });
}

TEST_CASE("NeuS: what is no camera is refused with its entry") {
  CHECK(refuses(file({}), "not a camera file"));
  ZipWriter other;
  other.add("poses.npy", test::npy("<f8", "(4, 4)", test::bytes_of<double>(matrix())));
  CHECK(refuses(other.finish(), "no world_mat_0"));
  CHECK(refuses(file({test::npy("<f8", "(2, 2)", test::bytes_of<double>({1, 2, 3, 4}))}),
                "world_mat_0 does not have 4x4 numbers"));
  CHECK(refuses(file({test::npy("<f8", "(4, 4)", std::string(128, '\0'))}), "singular"));
  CHECK(refuses(file({"x"}), "world_mat_0"));
  test::check_damaged(file({test::npy("<f8", "(4, 4)", test::bytes_of<double>(matrix()))}));
}
