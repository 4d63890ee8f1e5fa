#include "io/formats/point_text.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

namespace {

Mesh read(const std::string& text) { return read_point_text({text, "scan.P3D"}).document.mesh; }

bool is_points(const std::string& text, const std::string& name = "scan.txt") {
  return is_point_text({text, name});
}

}  // namespace

TEST_CASE("lines of six numbers are points with normals") {
  const Mesh mesh = read("# scanned\r\n0.5 -1e-3 2 0 0 1\r\n\r\n  1 2 3\t-1 0 0  # last\r\n");
  REQUIRE(mesh.positions.size() == 2);
  CHECK(mesh.positions[0] == Vec3(0.5, -1e-3, 2));
  CHECK(mesh.positions[1] == Vec3(1, 2, 3));
  CHECK(mesh.vertex_columns.find("nx")->values == std::vector<double>{0, -1});
  CHECK(mesh.vertex_columns.find("nz")->values == std::vector<double>{1, 0});
  CHECK(mesh.faces.empty());
}

TEST_CASE("lines of three numbers are points without normals") {
  const Mesh mesh = read("1 2 3\n4 5 6");
  CHECK(mesh.positions.size() == 2);
  CHECK(mesh.vertex_columns.columns.empty());
}

TEST_CASE("numbers that look like colors are left out with a note, and a first line keeps them") {
  const std::string text = "1 2 3 255 0 1\n4 5 6 0 255 0\n";
  const ReadResult result = read_point_text({text, "scan.xyz"});
  CHECK(result.document.mesh.vertex_columns.columns.empty());
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0].find("look like colors") != std::string::npos);
  const ReadResult named = read_mesh("x y z red green blue\n" + text, "scan.xyz");
  CHECK(named.document.mesh.vertex_columns.find("red")->values == std::vector<double>{255, 0});
  CHECK(named.notes.empty());
}

TEST_CASE("anything else is refused with its line") {
  CHECK_THROWS_WITH_AS(read("1 2 3\n4 5\n"), doctest::Contains("line 2"), InputError);
  CHECK_THROWS_WITH_AS(read("1 2 3\n\n4 5 6 7 8 9\n"), doctest::Contains("line 3"), InputError);
  CHECK_THROWS_WITH_AS(read("1 2 3 4\n"), doctest::Contains("has 4"), InputError);
  CHECK_THROWS_WITH_AS(read("1 2 3 4 5 x\n"), doctest::Contains("nz of point 0"), InputError);
}

TEST_CASE("points and normals that are not finite are dropped with a count") {
  const std::string text = "1 nan 3 0 0 1\n4 5 6 0 0 1\n7 8 9 0 inf 1\n1 2 3 1 0 0\n";
  const ReadResult result = read_point_text({text, "scan.xyz"});
  const Mesh& mesh = result.document.mesh;
  CHECK(mesh.positions == std::vector<Vec3>{{4, 5, 6}, {7, 8, 9}, {1, 2, 3}});
  CHECK(mesh.vertex_columns.find("nz")->values == std::vector<double>{1, 0, 0});
  CHECK(result.notes ==
        std::vector<std::string>{"points: 1 normal that is not finite becomes 0",
                                 "points: 1 vertex with a coordinate that is not finite dropped"});
  CHECK_THROWS_WITH_AS(read_point_text({text, "scan.xyz", true}), doctest::Contains("y of point 0"),
                       InputError);
}

TEST_CASE("points are distinguished from meshes by their first line") {
  CHECK(is_points("1 2 3 0 0 1\n"));
  CHECK(is_points("# comment\n 1 2 3\n"));
  CHECK(is_points("1 2 3 0 0 1\n", "odd.off"));
  CHECK_FALSE(is_points("8 12 0\n", "cube.off"));
  CHECK_FALSE(is_points("OFF\n8 12 0\n"));
  CHECK_FALSE(is_points("ply\nformat ascii 1.0\n"));
  CHECK_FALSE(is_points("v 1 2 3\n"));
  CHECK_FALSE(is_points("1 2 x\n"));
  CHECK_FALSE(is_points("1 2 3 4\n"));
  CHECK_FALSE(is_points(""));
  CHECK_FALSE(is_points(std::string("1 2 3\0", 6)));
}

TEST_CASE("numbers that are no points are refused with the reason") {
  const auto check = [](const std::string& text) { check_point_text({text, "scan.txt"}); };
  CHECK_THROWS_WITH_AS(
      check("# x\n1 2 3 4\n"),
      "a point has 3 numbers (x y z) or 6 (and nx ny nz), but this line has 4: take "
      "the first three, by awk '{ print $1, $2, $3 }' (scan.txt line 2)",
      InputError);
  CHECK_THROWS_WITH_AS(check("1,2,3\n"), doctest::Contains("replace the commas"), InputError);
  for (const char* text : {"x,y,z\n1,2,3\n", "hello 1 2\n", "", "\n"}) CHECK_NOTHROW(check(text));
}
