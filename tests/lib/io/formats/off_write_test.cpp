#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

}  // namespace

TEST_CASE("off: colors that no int holds are doubles, and come back") {
  const std::string start = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ";
  for (const std::string color : {"23.25", "3000000000", "1 2 3000000000", "-3000000000 0 0 1"}) {
    CAPTURE(color);
    const Document document = read_document(start + color + '\n');
    const Columns& columns = document.mesh.face_columns;
    CHECK(columns.columns.at(0).type == Scalar::float64);
    const Document again = read_document(write_mesh(document).bytes);
    for (const Column& given : columns.columns) {
      CHECK(column(again.mesh.face_columns, given.name).values == given.values);
      CHECK(column(again.mesh.face_columns, given.name).type == given.type);
    }
  }
}

TEST_CASE("off: faces without a color among others are white and opaque, and that is said") {
  const ReadResult result =
      read_mesh("OFF\n4 3 0\n" + points + "3 0 1 2\n3 0 1 3 1 2 3 4\n3 1 2 3 5 6 7\n", "input");
  const Columns& columns = result.document.mesh.face_columns;
  CHECK(column(columns, "red").values == std::vector<double>{255, 1, 5});
  CHECK(column(columns, "alpha").values == std::vector<double>{255, 4, 255});
  CHECK(has_note(result.notes, "off: 1 face without a color made white"));
}

TEST_CASE("off: colors of ushort are decimals, because integers are from 0 to 255") {
  Document document{tetrahedron(), {}, {}};
  document.style.format = Format::off;
  for (const char* name : {"red", "green", "blue"})
    document.mesh.vertex_columns.get(name, Scalar::uint16, 4).values = {0, 13107, 32768, 65535};
  document.mesh.face_columns.get("color_index", Scalar::uint16, 4).values = {300, 1, 2, 3};
  const Document back = read_document(write_mesh(document).bytes);
  CHECK(column(back.mesh.vertex_columns, "red").type == Scalar::float64);
  CHECK(column(back.mesh.vertex_columns, "red").values ==
        std::vector<double>{0, 0.2, 32768.0 / 65535, 1});
  CHECK(column(back.mesh.face_columns, "color_index").values == std::vector<double>{300, 1, 2, 3});
}

TEST_CASE("off: what cannot be kept is named once") {
  Document document;
  document.mesh = tetrahedron();
  document.mesh.vertex_columns.get("quality", Scalar::float32, 4);
  document.mesh.vertex_columns.get("nx", Scalar::float32, 4);
  document.mesh.face_columns.get("label", Scalar::int32, 4);
  document.other_elements.push_back({"edge", 0, {}});
  document.style.obj_info = {"x"};
  document.style.format = Format::off;
  CHECK(write_mesh(document).notes ==
        std::vector<std::string>{"off: vertex property 'quality' cannot be stored in OFF, dropped",
                                 "off: vertex property 'nx' cannot be stored in OFF, dropped",
                                 "off: face property 'label' cannot be stored in OFF, dropped",
                                 "off: element 'edge' cannot be stored in OFF, dropped",
                                 "off: obj_info cannot be stored in OFF, dropped"});
}

TEST_CASE("off: a color or normal that is not finite cannot be kept") {
  Document document;
  document.mesh = tetrahedron();
  document.style.format = Format::off;
  for (const char* name : {"red", "green", "blue", "nx", "ny", "nz"})
    document.mesh.vertex_columns.get(name, Scalar::float32, 4);
  document.mesh.vertex_columns.get("green", Scalar::float32, 4).values[2] = std::nan("");
  document.mesh.vertex_columns.get("nz", Scalar::float32, 4).values[1] = INFINITY;
  const WriteResult written = write_mesh(document);
  CHECK(written.notes.size() == 6);
  CHECK(read_mesh(written.bytes, "written").document.mesh.faces == document.mesh.faces);
}

TEST_CASE("off: where one channel is floating point, all are written from 0 to 1") {
  Document document = read_document("OFF\n1 0 0\n0 0 0 51 2 255\n");
  document.mesh.vertex_columns.find("green")->type = Scalar::float32;
  const std::string text = write_mesh(document).bytes;
  CHECK(text == "COFF\n1 0 0\n0 0 0 0.2 2.0 1.0\n");
  CHECK(rewritten(text) == text);
}

TEST_CASE("off: float coordinates are written as the doubles that they are") {
  Document document;
  document.mesh.positions = {Vec3(static_cast<double>(0.1F), 0, 0)};
  document.style.format = Format::off;
  document.style.coordinate = Scalar::float32;
  CHECK(read_document(write_mesh(document).bytes).mesh.positions == document.mesh.positions);
}
