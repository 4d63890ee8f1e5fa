#include "transformesh/document.h"

#include "helpers/shapes.h"
#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

Document document_of(Mesh mesh) { return {std::move(mesh), {}, {}}; }

Document with_edges(Scalar type) {
  Document document = document_of(test::tetrahedron());
  OtherElement& edges = document.other_elements.emplace_back(OtherElement{"edge", 2, {}});
  edges.columns.get("vertex1", type, 2).values = {0, 1};
  edges.columns.get("vertex2", type, 2).values = {2, -1};
  edges.columns.get("label", type, 2).values = {1, 1};
  return document;
}

Mesh colored(Scalar type, double value) {
  Mesh mesh = test::tetrahedron();
  for (const char* name : {"red", "green", "blue"})
    mesh.vertex_columns.get(name, type, 4).values.assign(4, value);
  return mesh;
}

}  // namespace

TEST_CASE("documents are joined: faces are renumbered, comments not repeated") {
  Document first, second;
  first.mesh = second.mesh = test::tetrahedron();
  first.style.comments = {"one", "tm:reference-edge 2"};
  second.style.comments = {"one", "tm:reference-edge 3", "two"};
  second.mesh.face_columns.get("label", Scalar::uint8, 4).values = {1, 2, 3, 4};
  CHECK(append(first, second).empty());
  CHECK(first.mesh.faces[4] == Face{4, 6, 5});
  CHECK(column(first.mesh.face_columns, "label").values ==
        std::vector<double>{0, 0, 0, 0, 1, 2, 3, 4});
  CHECK(first.style.comments == std::vector<std::string>{"one", "tm:reference-edge 2", "two"});
}

TEST_CASE("joined documents have edges between their own vertices") {
  Document all = document_of(test::cube());
  for (int i = 0; i < 2; ++i) CHECK(append(all, with_edges(Scalar::int32)).empty());
  REQUIRE(all.other_elements.size() == 1);
  const Columns& edges = all.other_elements[0].columns;
  CHECK(column(edges, "vertex1").values == std::vector<double>{8, 9, 12, 13});
  CHECK(column(edges, "vertex2").values == std::vector<double>{10, -1, 14, -1});
  CHECK(column(edges, "label").values == std::vector<double>{1, 1, 1, 1});
  CHECK(append(all, document_of(test::cube())).empty());
  CHECK(write_mesh(all).notes.empty());
}

TEST_CASE("numbers of vertices in joined edges get a type that holds them") {
  Document all = document_of(test::icosphere(2));
  append(all, with_edges(Scalar::int8));
  const Columns& edges = all.other_elements[0].columns;
  CHECK(column(edges, "vertex1").values[0] == 162);
  CHECK(column(edges, "vertex1").type == Scalar::int16);
  CHECK(column(edges, "label").type == Scalar::int8);
}

TEST_CASE("joined documents keep the unit of the first, and differences are noted") {
  Document first, second;
  first.style.comments = {"tm:unit millimeter"};
  second.style.comments = {"tm:unit meter"};
  CHECK(append(first, second) ==
        std::vector<std::string>{
            "the units differ, millimeter and meter: coordinates are used without conversion"});
  CHECK(first.style.comments == std::vector<std::string>{"tm:unit millimeter"});
  CHECK(append(second, Document()).empty());
}

TEST_CASE("texture coordinates of vertices join those of face corners, first or second") {
  for (const bool is_first : {true, false}) {
    Document of_vertices = document_of(test::tetrahedron()), of_corners = of_vertices;
    of_vertices.mesh.vertex_columns.get("s", Scalar::float32, 4).values = {0, 1, 2, 3};
    of_vertices.mesh.vertex_columns.get("t", Scalar::float32, 4).values = {4, 5, 6, 7};
    Column& lists = of_corners.mesh.face_columns.get("texcoord", Scalar::float32, 0);
    lists.list_count_type = Scalar::uint8;
    lists.list_offsets = {0, 6, 6, 6, 6};
    lists.values = {9, 9, 8, 8, 7, 7};
    Document& all = is_first ? of_vertices : of_corners;
    CHECK(append(all, is_first ? of_corners : of_vertices).size() == 1);
    CHECK(all.mesh.vertex_columns.columns.empty());
    const Column& joined = column(all.mesh.face_columns, "texcoord");
    REQUIRE(joined.values.size() == 30);
    const std::size_t start = joined.list_offsets[is_first ? 0 : 4];
    const Face face = test::tetrahedron().faces[0];
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(joined.values[start + 2 * i] == face[i]);
      CHECK(joined.values[start + 2 * i + 1] == face[i] + 4);
    }
    CHECK(joined.values[is_first ? 24 : 0] == 9);
  }
}

TEST_CASE("a mesh without colors becomes white beside a colored one, first or second") {
  for (const auto& [type, value, white] :
       {std::tuple(Scalar::uint8, 7.0, 255.0), std::tuple(Scalar::float32, 0.25, 1.0)})
    for (const bool is_first : {true, false}) {
      Document all = document_of(is_first ? colored(type, value) : test::tetrahedron());
      const auto notes =
          append(all, document_of(is_first ? test::tetrahedron() : colored(type, value)));
      REQUIRE(notes.size() == 1);
      CHECK(notes[0].find("white") != std::string::npos);
      const std::vector<double>& red = all.mesh.vertex_columns.find("red")->values;
      CHECK(red[0] == (is_first ? value : white));
      CHECK(red[7] == (is_first ? white : value));
    }
}

TEST_CASE("two colored meshes, and two without colors, cause no note") {
  Document all = document_of(colored(Scalar::uint8, 7));
  CHECK(append(all, document_of(colored(Scalar::uint8, 9))).empty());
  Document plain = document_of(test::cube());
  CHECK(append(plain, document_of(test::tetrahedron())).empty());
  CHECK(plain.mesh.faces.size() == 16);
}
