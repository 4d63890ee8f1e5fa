#include "io/formats/column_groups.h"

#include "helpers/shapes.h"
#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("column groups: columns of one type that are all there") {
  Columns columns;
  for (const char* name : {"red", "green", "blue"}) columns.get(name, Scalar::uint16, 2);
  CHECK(color_group(columns).size() == 3);
  columns.get("alpha", Scalar::uint8, 2);
  CHECK(color_group(columns).size() == 3);
  columns.get("alpha", Scalar::uint16, 2);
  CHECK(color_group(columns).size() == 4);
  columns.erase("blue");
  CHECK(color_group(columns).empty());
}

TEST_CASE("column groups: colors in the range of their type") {
  for (const auto& [type, full] :
       {std::pair{Scalar::uint16, 65535.0}, {Scalar::int32, 255.0}, {Scalar::float64, 1.0}}) {
    Columns columns;
    for (const char* name : {"red", "green", "blue"}) columns.get(name, type, 2).values = {0, full};
    CHECK(are_in_range(color_group(columns)));
    columns.find("blue")->values[1] = 1.01 * full;
    CHECK_FALSE(are_in_range(color_group(columns)));
    columns.find("blue")->values[1] = -0.01;
    CHECK_FALSE(are_in_range(color_group(columns)));
  }
}

TEST_CASE("column groups: texture coordinates of vertices become those of corners") {
  Mesh mesh = test::tetrahedron();
  make_corner_texture(mesh.faces, mesh);
  CHECK(mesh.face_columns.columns.empty());
  mesh.vertex_columns.get("u", Scalar::float64, 4).values = {0, 1, 2, 3};
  mesh.vertex_columns.get("v", Scalar::float64, 4).values = {4, 5, 6, 7};
  make_corner_texture(mesh.faces, mesh);
  CHECK(mesh.vertex_columns.columns.empty());
  const Column* lists = corner_texture(mesh.face_columns);
  REQUIRE(lists != nullptr);
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(lists->values[6 * f + 2 * i] == mesh.faces[f][i]);
      CHECK(lists->values[6 * f + 2 * i + 1] == mesh.faces[f][i] + 4);
    }
}
