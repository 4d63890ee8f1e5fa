#include "io/formats/three_mf.h"
#include "lib/io/bytes.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

Document three_mf_document() {
  Document document;
  document.mesh = tetrahedron();
  document.style.format = Format::three_mf;
  return document;
}

}  // namespace

TEST_CASE("3mf: what is written is read, in doubles, with unit and comments") {
  Document document = three_mf_document();
  document.mesh.positions[1].x() = 0.1;
  document.style.comments = {"a <b> & c", "tm:unit foot"};
  const Document again = read_document(write_mesh(document).bytes);
  CHECK(again.mesh.positions == document.mesh.positions);
  CHECK(again.mesh.faces == document.mesh.faces);
  CHECK(again.style.comments == document.style.comments);
  CHECK(write_mesh(again).bytes == write_mesh(document).bytes);
}

TEST_CASE("3mf: colors of vertices or of faces") {
  Document document = three_mf_document();
  for (const char* name : {"red", "green", "blue"})
    document.mesh.face_columns.get(name, Scalar::uint8, 4).values = {255, 0, 0, 7};
  const Document of_faces = read_document(write_mesh(document).bytes);
  CHECK(column(of_faces.mesh.face_columns, "green").values == std::vector<double>{255, 0, 0, 7});
  for (const char* name : {"red", "green", "blue", "alpha"})
    document.mesh.vertex_columns.get(name, Scalar::uint8, 4).values = {1, 2, 3, 4};
  const WriteResult result = write_mesh(document);
  CHECK(has_note(result.notes, "3mf: face property 'red' cannot be stored in 3MF, dropped"));
  const Document of_vertices = read_document(result.bytes);
  CHECK(column(of_vertices.mesh.vertex_columns, "alpha").values == std::vector<double>{1, 2, 3, 4});
  CHECK(of_vertices.mesh.face_columns.columns.empty());
}

TEST_CASE("3mf: colors of other types are rounded to bytes, with a note") {
  for (const Scalar type : {Scalar::uint16, Scalar::float32, Scalar::int32}) {
    const double full = type == Scalar::uint16 ? 65535 : type == Scalar::int32 ? 255 : 1;
    Document document{tetrahedron(), {}, {}};
    document.style.format = Format::three_mf;
    for (const char* name : {"red", "green", "blue"})
      document.mesh.vertex_columns.get(name, type, 4).values = {0, full / 5, full, full};
    const auto exact = write_mesh(document);
    CHECK(exact.notes.empty());
    CHECK(column(read_document(exact.bytes).mesh.vertex_columns, "red").values ==
          std::vector<double>{0, 51, 255, 255});
    if (type == Scalar::int32) continue;
    document.mesh.vertex_columns.find("red")->values[0] = full / 1000;
    CHECK(write_mesh(document).notes ==
          std::vector<std::string>{"3mf: colors are rounded to bytes"});
    document.mesh.vertex_columns.find("red")->values[0] = -1;
    CHECK(write_mesh(document).notes.size() == 3);  // the three columns are dropped
  }
}

TEST_CASE("3mf: no points, and no triangles of two corners") {
  Document document = three_mf_document();
  document.mesh.faces.push_back({1, 1, 2});
  const WriteResult result = write_mesh(document);
  CHECK(has_note(result.notes,
                 "3mf: 1 face with two corners in one vertex cannot be stored in 3MF, dropped"));
  CHECK(read_document(result.bytes).mesh.faces.size() == 4);
  document.mesh.faces.clear();
  CHECK_THROWS_AS(write_mesh(document), GoalError);
}
