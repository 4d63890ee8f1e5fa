#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

TEST_CASE("obj: colors from bytes become bytes, others stay decimals") {
  const Columns bytes = read_document("v 0 0 0 1 0 0.5019607843137255\n").mesh.vertex_columns;
  CHECK(column(bytes, "blue").type == Scalar::uint8);
  CHECK(column(bytes, "blue").values == std::vector<double>{128});
  const std::string text = "v 0 0 0 0.3 1 0.5\nv 1 0 0 0 0 0\n";
  CHECK(column(read_document(text).mesh.vertex_columns, "red").type == Scalar::float64);
  CHECK(rewritten(text) == text);

  Document document;
  document.style.format = Format::obj;
  for (int i = 0; i < 256; ++i) document.mesh.positions.emplace_back(i, 0, 0);
  for (const char* name : {"red", "green", "blue"}) {
    std::vector<double>& values = document.mesh.vertex_columns.get(name, Scalar::uint8, 256).values;
    for (std::size_t i = 0; i < 256; ++i) values[i] = static_cast<double>(i);
  }
  const Document back = read_document(write_mesh(document).bytes);
  CHECK(column(back.mesh.vertex_columns, "green").type == Scalar::uint8);
  CHECK(column(back.mesh.vertex_columns, "green").values ==
        document.mesh.vertex_columns.find("green")->values);

  const ReadResult partial = read_mesh("v 0 0 0 1 0 0\nv 1 0 0\n", "input");
  CHECK(has_note(partial.notes, "obj: 1 point without a color made white"));
  CHECK(column(partial.document.mesh.vertex_columns, "red").values ==
        std::vector<double>{255, 255});
  CHECK(column(partial.document.mesh.vertex_columns, "blue").values == std::vector<double>{0, 255});
}

namespace {

Document obj_document() {
  Document document;
  document.mesh = tetrahedron();
  document.mesh.faces.resize(2);
  document.style.format = Format::obj;
  return document;
}

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

}  // namespace

TEST_CASE("obj: colors of type ushort are divided by 65535") {
  Document document;
  document.style.format = Format::obj;
  document.mesh.positions.emplace_back(0, 0, 0);
  for (const char* name : {"red", "green", "blue"})
    document.mesh.vertex_columns.get(name, Scalar::uint16, 1).values = {65535};
  CHECK(write_mesh(document).bytes == "v 0 0 0 1 1 1\n");
}

TEST_CASE("obj: comments, libraries and labels are lines of their own") {
  Document document = obj_document();
  document.style.comments = {"by hand", "tm:mtllib a#b.mtl", "tm:group 3 wing"};
  document.mesh.face_columns.get("group", Scalar::int32, 2).values = {3, 4};
  document.mesh.face_columns.get("material", Scalar::int32, 2).values = {5, 0};
  const WriteResult result = write_mesh(document);
  CHECK(result.bytes == "# by hand\nmtllib a_b.mtl\n" + vertices +
                            "g wing\nusemtl 5\nf 1 3 2\ng 4\nusemtl 0\nf 1 2 4\n");
  CHECK(result.notes.empty());
}

TEST_CASE("obj: a comment that becomes that of a label by its blanks is left out") {
  Document document = obj_document();
  document.style.comments = {std::string("tm:object\0x", 11), "tm:group\r1 wing", "by\nhand"};
  const std::string bytes = write_mesh(document).bytes;
  CHECK(bytes.starts_with("# by hand\nv "));
  CHECK(write_mesh(read_mesh(bytes, "-").document).bytes == bytes);
}

TEST_CASE("obj: texture coordinates that are equal to the last bit are written once") {
  Document document = obj_document();
  Column lists{"texcoord", Scalar::float64, {0, 0, -0.0, 0, 0, 0}, Scalar::uint8, {0, 6, 6}};
  document.mesh.face_columns.columns.push_back(lists);
  CHECK(write_mesh(document).bytes == vertices + "vt 0 0\nvt -0 0\nf 1/1 3/2 2/1\nf 1 2 4\n");
}

TEST_CASE("obj: a mesh without vertices is still an OBJ file, and what does not fit is named") {
  Document document;
  document.style.format = Format::obj;
  CHECK(write_mesh(document).bytes == "o empty\n");
  CHECK(read_document("o empty\n").style.format == Format::obj);

  document = obj_document();
  for (const char* name : {"s", "t"}) document.mesh.vertex_columns.get(name, Scalar::int32, 4);
  document.mesh.face_columns.get("group", Scalar::float32, 2);
  const WriteResult result = write_mesh(document);
  CHECK(result.bytes == vertices + "f 1 3 2\nf 1 2 4\n");
  CHECK(result.notes ==
        std::vector<std::string>{"obj: vertex property 's' cannot be stored in OBJ, dropped",
                                 "obj: vertex property 't' cannot be stored in OBJ, dropped",
                                 "obj: face property 'group' cannot be stored in OBJ, dropped"});
  document.mesh.positions[3].z() = std::nan("");
  CHECK_THROWS_AS(write_mesh(document), GoalError);
}
