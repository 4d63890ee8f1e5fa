#include <zlib.h>

#include "io/formats/vtk.h"
#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

const std::string start = "# vtk DataFile Version 3.0\na title\nASCII\nDATASET POLYDATA\n";
const std::string square = "POINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\n";

}  // namespace

TEST_CASE("vtk: polygons and strips with the data of points and cells") {
  const ReadResult result =
      read_mesh(start + square +
                    "LINES 1 3 2 0 1\nPOLYGONS 1 5 4 0 1 2 3\nTRIANGLE_STRIPS 1 5 4 0 1 3 2\n"
                    "CELL_DATA 3\nSCALARS label int\nLOOKUP_TABLE default\n7 8 9\n"
                    "POINT_DATA 4\nVECTORS v double\n1 0 0 2 0 0 3 0 0 4 0 0\nNORMALS n float\n0 0 "
                    "1 0 0 1 0 0 "
                    "1 0 0 1\nCOLOR_SCALARS c 3\n1 0 0.2 0 0 0 0 0 0 0 0 0\n"
                    "TEXTURE_COORDINATES t 2 float\n0 0 1 0 1 1 0 1\n",
                "input");
  const Mesh& mesh = result.document.mesh;
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}});
  CHECK(column(mesh.face_columns, "label").values == std::vector<double>{8, 8, 9, 9});
  CHECK(column(mesh.vertex_columns, "v").values[3] == 2);
  CHECK(column(mesh.vertex_columns, "v").list_offsets[1] == 3);
  CHECK(column(mesh.vertex_columns, "nz").values[2] == 1);
  CHECK(column(mesh.vertex_columns, "red").values[0] == 255);
  CHECK(column(mesh.vertex_columns, "blue").values[0] == 51);
  CHECK(column(mesh.vertex_columns, "t").values[3] == 1);
  CHECK(has_note(result.notes, "vtk: 1 cell other than polygons left out"));
  CHECK(result.document.style.comments == std::vector<std::string>{"a title"});
}

TEST_CASE("vtk: binary of version 5.1, big-endian, with arrays of offsets") {
  Bytes bytes(true);
  bytes.text("# vtk DataFile Version 5.1\n\nBINARY\nDATASET POLYDATA\nPOINTS 3 double\n");
  for (const double x : {0.1, 0., 0., 1., 0., 0., 0., 1., 0.}) bytes.f64(x);
  bytes.text("\nMETADATA\nINFORMATION 0\n\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n");
  for (const std::uint64_t offset : {0, 3}) bytes.u32(0).u32(offset);
  bytes.text("\nCONNECTIVITY vtktypeint64\n");
  for (const std::uint64_t corner : {0, 1, 2}) bytes.u32(0).u32(corner);
  bytes.text("\nPOINT_DATA 3\nFIELD FieldData 1\nheat 1 3 float\n").f32(1).f32(2).f32(3).text("\n");
  const Document document = read_document(bytes.str());
  CHECK(document.mesh.positions[0].x() == 0.1);
  CHECK(document.mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(column(document.mesh.vertex_columns, "heat").values == std::vector<double>{1, 2, 3});
  CHECK(document.style.coordinate == Scalar::float64);
  CHECK(contains(read_error(bytes.str().substr(0, 120)), "(input byte "));
}

TEST_CASE("vtk: polygons of unstructured grids, without their volumes") {
  const std::string grid = "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\n" +
                           square +
                           "CELLS 3 13\n4 0 1 2 3\n3 0 1 2\n3 0 2 3\nCELL_TYPES 3\n10 5 5\n"
                           "CELL_DATA 3\nSCALARS m short 1\nLOOKUP_TABLE default\n1 2 3\n";
  const ReadResult result = read_mesh(grid, "input");
  CHECK(result.document.mesh.faces == std::vector<Face>{{0, 1, 2}, {0, 2, 3}});
  CHECK(column(result.document.mesh.face_columns, "m").values == std::vector<double>{2, 3});
  CHECK(has_note(result.notes, "vtk: 1 cell other than polygons left out"));
}

TEST_CASE("vtk: what is wrong is named") {
  const auto error_with = [](const std::string& rest) { return read_error(start + rest); };
  CHECK(contains(error_with(square + "POLYGONS 1 4 3 0 1 4\n"), "cell 0 has point index 4"));
  CHECK(contains(error_with(square + "POLYGONS 1 4 9 0 1 2\n"), "reaches beyond the list"));
  CHECK(contains(error_with(square + "POLYGONS 2 4 3 0 1 2\n"), "2 cells are announced"));
  CHECK(contains(error_with(square + "POLYGONS 1 4 3 0 1 -2\n"), "not a whole number"));
  CHECK(contains(error_with("POINTS 99999999999 float\n"), "elements are announced"));
  CHECK(contains(error_with("POINTS 50 float\n1 2 3"), "150 numbers of 'points' are announced"));
  CHECK(contains(error_with("POINTS 1 float\n1 2 x"), "number 2 of 'points' is 'x'"));
  CHECK(contains(error_with("POINTS 1 bit\n1 2 3"), "the type 'bit' are not supported"));
  CHECK(contains(error_with("WORD\n"), "the unknown word 'word'"));
  CHECK(contains(error_with(square + "POINT_DATA 3\nSCALARS a int\n1 2 3\n"),
                 "the array 'a' has 3 numbers, but there are 4 points of 1 component"));
  CHECK(contains(read_error("# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_GRID\n"),
                 "'structured_grid' is not supported as a surface"));
}
