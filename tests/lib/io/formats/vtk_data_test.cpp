#include "io/formats/vtk_data.h"

#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

/// Four points, a quadrilateral and a strip of two triangles, after one cell of another type.
VtkPiece piece() {
  VtkPiece piece;
  piece.points.values = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  piece.polygons = {{0, 4}, {0, 1, 2, 3}, {1}};
  piece.strips = {{0, 4}, {0, 1, 3, 2}, {2}};
  piece.cells = 3;
  piece.other_cells = 1;
  return piece;
}

ReadResult mesh_of(VtkPiece piece) {
  static const Source source{"", "input"};
  return mesh_of_vtk(source, std::move(piece));
}

}  // namespace

TEST_CASE("vtk data: rows of cells go to the triangles that cells become") {
  VtkPiece given = piece();
  given.cell_arrays.push_back({"id", "", Scalar::int32, 1, {5, 6, 7}});
  const Mesh mesh = mesh_of(given).document.mesh;
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}});
  CHECK(column(mesh.face_columns, "id").values == std::vector<double>{6, 6, 7, 7});
}

TEST_CASE("vtk data: integers that doubles may not hold are reported") {
  for (const std::size_t bytes : {std::size_t{4}, std::size_t{8}}) {
    VtkPiece given = piece();
    VtkArray& array = given.point_arrays.emplace_back();
    array.name = "id";
    array.values = {1, 2, 0x1p53, 3};
    set_type(false, true, bytes, array);
    const ReadResult result = mesh_of(given);
    CHECK(column(result.document.mesh.vertex_columns, "id").values[2] == 0x1p53);
    CHECK(has_note(result.notes,
                   "vtk: 1 integer of array 'id' is 2^53 or larger, and may be rounded: numbers "
                   "are kept as doubles") == (bytes == 8));
  }
}

TEST_CASE("vtk data: names that PLY cannot have, and arrays that are too wide") {
  VtkPiece given = piece();
  given.point_arrays.push_back({"Point Ids", "", Scalar::int32, 1, {1, 2, 3, 4}});
  given.point_arrays.push_back({"x", "", Scalar::float32, 1, {1, 2, 3, 4}});
  given.point_arrays.push_back(
      {"wide", "", Scalar::uint8, 256, std::vector<double>(std::size_t{4} * 256)});
  const ReadResult result = mesh_of(given);
  const Columns& columns = result.document.mesh.vertex_columns;
  CHECK(column(columns, "Point_Ids").values[3] == 4);
  CHECK(column(columns, "x_").values[3] == 4);
  CHECK(columns.columns.size() == 2);
  CHECK(has_note(result.notes, "vtk: array 'wide' of 256 components left out"));
}

TEST_CASE(
    "vtk data: arrays named RGB and RGBA are colors in every type, and other vectors are not") {
  for (const Scalar type : {Scalar::uint8, Scalar::uint16, Scalar::float32, Scalar::float64}) {
    VtkPiece given = piece();
    given.point_arrays.push_back({"RGB", "", type, 3, {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0}});
    given.cell_arrays.push_back({"RGBA", "Scalars", type, 4, {1, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1}});
    const Mesh mesh = mesh_of(given).document.mesh;
    CHECK(column(mesh.vertex_columns, "green").type == type);
    CHECK(column(mesh.vertex_columns, "green").values == std::vector<double>{0, 0, 0, 1});
    CHECK(mesh.vertex_columns.columns.size() == 3);
    CHECK(column(mesh.face_columns, "alpha").values == std::vector<double>(4, 1));
  }
  VtkPiece given = piece();
  given.point_arrays.push_back({"force", "Scalars", Scalar::float32, 3, std::vector<double>(12)});
  CHECK(column(mesh_of(given).document.mesh.vertex_columns, "force").list_count_type);
}

TEST_CASE("vtk data: indices, offsets and lengths out of range") {
  VtkPiece given = piece();
  given.polygons.connectivity[2] = 4;
  CHECK_THROWS_WITH_AS(mesh_of(given), "cell 1 has point index 4, but there are 4 points (input)",
                       InputError);
  given = piece();
  given.strips.offsets = {5, 4};
  CHECK_THROWS_WITH_AS(mesh_of(given), doctest::Contains("offsets of cell 2"), InputError);
  given = piece();
  given.cell_arrays.push_back({"id", "", Scalar::int32, 1, {5, 6}});
  CHECK_THROWS_WITH_AS(mesh_of(given),
                       doctest::Contains("'id' has 2 numbers, but there are 3 cells"), InputError);
}

TEST_CASE(
    "vtk data: types that hold the numbers, also those that text has beside the stated type") {
  const auto type_of = [](bool is_floating, bool is_signed, std::size_t bytes,
                          std::vector<double> values) {
    VtkArray array{"a", "", Scalar::float32, 1, std::move(values)};
    set_type(is_floating, is_signed, bytes, array);
    return array;
  };
  CHECK(type_of(false, true, 8, {1, -5}).type == Scalar::int32);
  CHECK(type_of(false, true, 8, {1e10}).type == Scalar::float64);
  CHECK(type_of(false, false, 2, {7}).type == Scalar::uint16);
  CHECK(type_of(false, false, 1, {256}).type == Scalar::int32);
  CHECK(type_of(false, false, 1, {0.5}).type == Scalar::float64);
  CHECK(type_of(false, true, 4, {std::nan("")}).type == Scalar::float64);
  CHECK(type_of(true, true, 4, {0.1}).values[0] == static_cast<double>(0.1F));
  CHECK(type_of(true, true, 8, {0.1}).values[0] == 0.1);
}
