#include "views/cameras/camera_place.h"

#include <doctest/doctest.h>

#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_file.h"

using namespace transformesh;

namespace {

constexpr const char* lenses = "1 PINHOLE 640 480 500 500 320 240\n";
constexpr const char* images = "1 1 0 0 0 0 0 5 1 a.jpg\n\n";

void make_model(const std::string& folder) {
  std::filesystem::create_directories(folder);
  test::make_file(folder + "/cameras.txt", lenses);
  test::make_file(folder + "/images.txt", images);
}

std::string refusal(const std::string& where) {
  try {
    cameras_from(where);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a folder without cameras is searched where COLMAP and MVSNet put them") {
  for (const std::string place : {"sparse/0", "0", "sparse", "dense/0/sparse", "dense/sparse"}) {
    const test::TemporaryFolder folder;
    make_model(folder / place);
    CHECK(folder_with_cameras(folder / "") == folder / place);
    CHECK(cameras_from(folder / "").cameras.size() == 1);
  }
  const test::TemporaryFolder folder;
  make_model(folder / "dense/0/sparse");
  CHECK(cameras_from(folder / "dense/0").cameras.size() == 1);
}

TEST_CASE("several models of COLMAP are refused, and so is a folder without any") {
  const test::TemporaryFolder folder;
  CHECK(refusal(folder / "").find("no camera file in this folder") != std::string::npos);
  make_model(folder / "sparse/0");
  make_model(folder / "sparse/1");
  CHECK(refusal(folder / "sparse").find("several models") != std::string::npos);
  CHECK(refusal(folder / "").find("several models") != std::string::npos);
  CHECK(refusal(folder / "sparse/1").empty());
}
