#include "io/formats/three_mf.h"
#include "lib/io/stored_zip.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

std::string model(const std::string& resources, const std::string& build) {
  return "<model unit=\"inch\"><resources>" + resources + "</resources><build>" + build +
         "</build></model>";
}

}  // namespace

TEST_CASE("3mf: items and components are joined where their transforms put them") {
  const std::string archive = three_mf_of(
      model("<object id=\"1\">" + three_mf_triangle(0) +
                "</object><object id=\"2\"><components><component objectid=\"1\" transform=\"1 0 0 "
                "0 1 0 0 "
                "0 1 0 0 5\"/></components></object>",
            "<item objectid=\"1\"/><item objectid=\"2\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 2\"/>"));
  const ReadResult result = read_mesh(archive, "input");
  const Mesh& mesh = result.document.mesh;
  REQUIRE(mesh.positions.size() == 6);
  CHECK(mesh.positions[4] == Vec3(-1, 0, 7));
  // faces of the mirror image are reversed
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {3, 5, 4}});
  CHECK(result.document.style.comments == std::vector<std::string>{"tm:unit inch"});
  CHECK(has_note(result.notes, "3mf: 2 objects read as one mesh"));
}

TEST_CASE("3mf: objects in other parts of the archive") {
  const std::string other = model("<object id=\"1\">" + three_mf_triangle(4) + "</object>", "");
  const std::string root = model("", "<item objectid=\"1\" p:path=\"/3D/Objects/a.model\"/>");
  CHECK(read_document(three_mf_of(root, {{"3D/Objects/a.model", other}})).mesh.positions[0].z() ==
        4);
  CHECK(contains(read_error(three_mf_of(root)), "no part '3D/Objects/a.model'"));
}

TEST_CASE("3mf: colors of faces, of vertices, and of corners that disagree") {
  const std::string group =
      "<colorgroup id=\"9\"><color color=\"#FF0000\"/><color color=\"#0000FF\"/></colorgroup>";
  const auto read = [&](const std::string& first, const std::string& second) {
    return read_mesh(
        three_mf_of(model(group +
                              "<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" "
                              "z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" "
                              "z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" "
                              "v3=\"2\" " +
                              first + "/><triangle v1=\"2\" v2=\"1\" v3=\"0\" " + second +
                              "/></triangles></mesh></object>",
                          "<item objectid=\"1\"/>")),
        "input");
  };
  const ReadResult of_faces = read("pid=\"9\" p1=\"0\"", "");
  CHECK(column(of_faces.document.mesh.face_columns, "blue").values == std::vector<double>{0, 255});
  const ReadResult of_vertices =
      read("pid=\"9\" p1=\"0\" p2=\"0\" p3=\"1\"", "pid=\"9\" p1=\"1\" p2=\"0\" p3=\"0\"");
  CHECK(column(of_vertices.document.mesh.vertex_columns, "red").values ==
        std::vector<double>{255, 255, 0});
  CHECK(of_vertices.document.mesh.face_columns.columns.empty());
  const ReadResult of_corners = read("pid=\"9\" p1=\"0\" p2=\"0\" p3=\"1\"", "");
  CHECK(column(of_corners.document.mesh.vertex_columns, "red").values ==
        std::vector<double>{255, 255, 0});
  CHECK(has_note(of_corners.notes,
                 "3mf: corners of a vertex have several colors, of which the first is kept"));
}

TEST_CASE("3mf: circles, missing objects and repetitions without end are refused") {
  const auto error_of = [](const std::string& resources) {
    return read_error(three_mf_of(model(resources, "<item objectid=\"1\"/>")));
  };
  const auto holder = [](int id, int held, int times) {
    std::string text = "<object id=\"" + std::to_string(id) + "\"><components>";
    for (int i = 0; i < times; ++i)
      text += "<component objectid=\"" + std::to_string(held) + "\"/>";
    return text + "</components></object>";
  };
  CHECK(contains(error_of(holder(1, 2, 1) + holder(2, 1, 1)), "object '1' contains itself"));
  CHECK(contains(error_of(""), "object '1' is used, but missing in '3D/3dmodel.model'"));
  std::string deep, wide;
  for (int id = 1; id <= 300; ++id) deep += holder(id, id + 1, 1);
  CHECK(contains(error_of(deep), "nested more than 256 deep"));
  for (int id = 1; id <= 40; ++id) wide += holder(id, id + 1, 10);
  CHECK(
      contains(error_of(wide + "<object id=\"41\"/>"), "repeated parts expand to more than 64 MB"));
  CHECK(contains(read_error(stored_zip({{"word/document.xml", ""}, {"_rels/.rels", "<R/>"}})),
                 "is not a 3MF file"));
  CHECK(contains(read_error(stored_zip({{"a.txt", ""}})), "no part '3D/3dmodel.model'"));
}
