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
