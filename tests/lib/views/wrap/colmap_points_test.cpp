#include "views/wrap/colmap_points.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/numpy_files.h"
#include "helpers/random.h"
#include "transformesh/columns.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

const std::string title = "# 3D point list with one line of data per point:\n";

std::string word(std::uint64_t number, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i) & 255U);
  return bytes;
}

std::string point(const std::vector<double>& position, double error, std::uint64_t track) {
  return word(9, 8) + test::bytes_of<double>(position) + word(10, 1) + word(20, 1) + word(255, 1) +
         test::bytes_of<double>({error}) + word(track, 8) + std::string(8 * track, 'x');
}

std::string file() { return word(2, 8) + point({1, 2, 3}, 0.5, 2) + point({-1, 0, 1e-3}, 1.5, 4); }

void check(const Mesh& mesh) {
  REQUIRE(mesh.positions.size() == 2);
  CHECK(mesh.positions[0] == Vec3(1, 2, 3));
  CHECK(mesh.positions[1] == Vec3(-1, 0, 1e-3));
  CHECK(mesh.vertex_columns.find("blue")->values == std::vector<double>{255, 255});
  CHECK(mesh.vertex_columns.find("error")->values == std::vector<double>{0.5, 1.5});
  CHECK(mesh.vertex_columns.find("track_length")->values == std::vector<double>{2, 4});
}

std::string refusal(const std::string& bytes, const std::string& name) {
  try {
    read_colmap_points({bytes, name});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("COLMAP's points are the same in text and in binary files") {
  const std::string text =
      title + "9 1 2 3 10 20 255 0.5 1 7 2 8\n9 -1 0 1e-3 10 20 255 1.5 1 1 2 2 3 3 4 4\n";
  check(read_colmap_points({text, "a.txt"}).value());
  check(read_colmap_points({file(), "points3D.bin"}).value());
  // Without a file name, as on a pipe, the exact size identifies the format.
  const std::string bytes = file();
  check(read_colmap_points({bytes, "standard input"}).value());
  CHECK_FALSE(read_colmap_points({bytes + "x", "standard input"}).has_value());
  CHECK_FALSE(read_colmap_points({"ply\nformat ascii 1.0\n", "a.ply"}).has_value());
  CHECK_FALSE(read_colmap_points({"1 2 3\n4 5 6\n", "a.xyz"}).has_value());
}

TEST_CASE("damaged points of COLMAP are refused with the line or the point") {
  CHECK(refusal(title + "9 1 2 3 10 20 255 0.5 1\n", "a").find("odd number") != std::string::npos);
  CHECK(refusal(title + "9 1 nan 3 10 20 255 0.5\n", "a").find("coordinate of point 9") !=
        std::string::npos);
  const std::string nan = word(1, 8) + point({1, std::nan(""), 3}, 0.5, 2);
  CHECK(refusal(nan, "points3D.bin").find("point 0") != std::string::npos);
  const std::string huge = word(1, 8) + point({1, 2, 3}, 0.5, 2).substr(0, 43) + word(~0ULL, 8);
  CHECK(refusal(huge, "points3D.bin").find("too early") != std::string::npos);
  const std::string whole = file();
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_FALSE(refusal(whole.substr(0, size), "points3D.bin").empty());
}
