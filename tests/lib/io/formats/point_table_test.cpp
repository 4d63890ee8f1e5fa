#include "io/formats/point_table.h"

#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("points: headers with names, in several spellings") {
  for (const char* header :
       {"x y z nx ny nz", "X,Y,Z,Nx,Ny,Nz", "//X Y Z normal_x normal_y normal_z",
        "\"x\";\"y\";\"z\";\"nx\";\"ny\";\"nz\""}) {
    const Mesh mesh = read_document(std::string(header) + "\n1,2 ,3;0 0 1\n").mesh;
    REQUIRE(mesh.positions.size() == 1);
    CHECK(mesh.positions[0] == Vec3(1, 2, 3));
    CHECK(column(mesh.vertex_columns, "nz").values == std::vector<double>{1});
  }
}

TEST_CASE("points: colors in bytes or not, and other names") {
  const Mesh mesh = read_document("r g b x y z heat\n255 0 9 1 2 3 -0.5\n").mesh;
  CHECK(column(mesh.vertex_columns, "blue").type == Scalar::uint8);
  CHECK(column(mesh.vertex_columns, "heat").values == std::vector<double>{-0.5});
  CHECK(column(read_document("x y z r g b\n1 2 3 0.5 0 1\n").mesh.vertex_columns, "red").type ==
        Scalar::float64);
}

TEST_CASE("points: a number of points alone in the first line") {
  const Mesh mesh = read_document("2\n1 2 3 -7 255 0 0\n4 5 6 7 0 255 0\n").mesh;
  CHECK(mesh.positions[1] == Vec3(4, 5, 6));
  CHECK(column(mesh.vertex_columns, "intensity").values == std::vector<double>{-7, 7});
  CHECK(column(mesh.vertex_columns, "green").values == std::vector<double>{0, 255});
}

TEST_CASE("points: lines that do not fit, and what is no such table") {
  CHECK(contains(read_error("x y z\n1 2 3\n4 5\n"), "z of point 1 is missing (input line 3)"));
  CHECK(contains(read_error("x y z\n1 2 3 4\n"), "line 2"));
  CHECK(contains(read_error("x,y,z\n1,2,a\n"), "z of point 0"));
  CHECK(contains(read_error("x y\n1 2\n"), "unknown mesh format"));
  CHECK(contains(read_error("x x y z\n1 1 2 3\n"), "unknown mesh format"));
  CHECK(contains(read_error("8\n"), "but this line has 1"));
}
