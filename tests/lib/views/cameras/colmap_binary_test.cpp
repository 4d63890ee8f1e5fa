#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"

using namespace transformesh;

namespace {

template <class Number>
void add(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.begin(), raw.end());
}

std::string cameras_bin(std::int32_t model, const std::vector<double>& parameters) {
  std::string bytes;
  add(bytes, std::uint64_t{1});
  add(bytes, std::int32_t{3});
  add(bytes, model);
  add(bytes, std::uint64_t{320});
  add(bytes, std::uint64_t{240});
  for (const double parameter : parameters) add(bytes, parameter);
  return bytes;
}

std::string images_bin() {
  std::string bytes;
  add(bytes, std::uint64_t{2});
  for (const char* name : {"left/a b.png", "c.png"}) {
    add(bytes, std::uint32_t{7});
    for (const double number : {0.6, 0.0, 0.8, 0.0, 1.0 / 3, -2.0, 5.0}) add(bytes, number);
    add(bytes, std::uint32_t{3});
    bytes.append(name).push_back('\0');
    add(bytes, std::uint64_t{1});
    bytes.append(24, 'x');
  }
  return bytes;
}

CameraList read(const std::string& cameras, const std::string& images) {
  return read_colmap_binary({cameras, "cameras.bin"}, {images, "images.bin"});
}

}  // namespace

TEST_CASE("COLMAP's binary files hold what its text does") {
  const CameraList list =
      read(cameras_bin(4, {300, 310, 160.5, 120.5, 0.1, 0.2, 0.3, 0.4}), images_bin());
  REQUIRE(list.cameras.size() == 2);
  const CameraRecord& record = list.cameras[0];
  CHECK(record.name == "left/a b.png");
  CHECK(record.width == 320);
  CHECK(record.camera.intrinsics(1, 1) == 310);
  CHECK(record.camera.intrinsics(0, 2) == 160);
  CHECK(record.camera.translation == Vec3(1.0 / 3, -2, 5));
  CHECK(record.distortion.radial[1] == 0.2);
  CHECK(record.distortion.tangential[0] == 0.3);
  CHECK(list.cameras[1].name == "c.png");
  CHECK(list.names_images);
}

TEST_CASE("COLMAP's binary files cut short, or of other models, are refused") {
  const std::string cameras = cameras_bin(1, {300, 310, 160.5, 120.5});
  const std::string images = images_bin();
  CHECK(read(cameras, images).cameras.size() == 2);
  for (std::size_t size = 0; size < images.size(); ++size)
    CHECK_THROWS_AS(read(cameras, images.substr(0, size)), InputError);
  for (std::size_t size = 0; size < cameras.size(); ++size)
    CHECK_THROWS_AS(read(cameras.substr(0, size), images), InputError);
  CHECK_THROWS_AS(read(cameras_bin(5, std::vector<double>(8, 1)), images), InputError);
  CHECK_THROWS_AS(read(cameras_bin(99, {}), images), InputError);
  CHECK_THROWS_AS(read(cameras_bin(-1, {}), images), InputError);
}
