#include "io/formats/glb.h"
#include "lib/io/gltf_text.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

Document written_and_read(Document document) {
  document.style.format = Format::glb;
  return read_document(write_mesh(document).bytes);
}

}  // namespace

TEST_CASE("glb: what is written is read: positions, columns, comments and unit") {
  Document document;
  document.mesh = tetrahedron();
  for (const char* name : {"red", "green", "blue"})
    document.mesh.vertex_columns.get(name, Scalar::uint8, 4).values = {0, 1, 128, 255};
  document.mesh.vertex_columns.get("quality", Scalar::float32, 4).values = {0, 1, 0.5, -2};
  document.style.comments = {"by hand", "tm:unit inch"};
  const Document again = written_and_read(document);
  CHECK(again.mesh.positions == document.mesh.positions);
  CHECK(again.mesh.faces == document.mesh.faces);
  CHECK(again.mesh.vertex_columns.columns.size() == 4);
  CHECK(column(again.mesh.vertex_columns, "blue").values == std::vector<double>{0, 1, 128, 255});
  CHECK(column(again.mesh.vertex_columns, "quality").values == std::vector<double>{0, 1, 0.5, -2});
  CHECK(again.style.comments == document.style.comments);
  CHECK(again.style.coordinate == Scalar::float32);
}

TEST_CASE("glb: texture coordinates of corners survive with the manifold") {
  Document document;
  document.mesh = tetrahedron();
  Column& lists = document.mesh.face_columns.get("texcoord", Scalar::float32, 0);
  lists.list_count_type = Scalar::uint8;
  lists.list_offsets = {0, 6, 12, 18, 24};
  for (int i = 0; i < 24; ++i) lists.values.push_back(i / 32.0);
  const Document again = written_and_read(document);
  CHECK(again.mesh.positions == document.mesh.positions);
  CHECK(again.mesh.faces == document.mesh.faces);
  CHECK(column(again.mesh.face_columns, "texcoord").values == lists.values);
  // Without the fourth face, EXT_mesh_manifold is not written, and copies of vertices stay.
  document.mesh.faces.pop_back();
  lists.list_offsets.pop_back();
  lists.values.resize(18);
  CHECK(written_and_read(document).mesh.positions.size() > 4);
}

TEST_CASE("glb: mirrored nodes turn faces, and their normals stay outside") {
  Json json = gltf_tetrahedron();
  Bytes normals;
  for (int i = 0; i < 4; ++i) normals.f32(0.6F).f32(0).f32(0.8F);
  first_primitive(json)["attributes"]["NORMAL"] = add_accessor(json, normals, 4, 5126, "VEC3");
  json["nodes"][0]["scale"] = {-2, 1, 1};
  const Document document = read_document(json.dump());
  CHECK(document.mesh.positions[1] == Vec3(-2, 0, 0));
  CHECK(document.mesh.faces[0] == Face{0, 1, 2});
  CHECK(document.style.coordinate == Scalar::float64);
  // The inverse transpose of the scaling takes (0.6, 0, 0.8) to (-0.3, 0, 0.8).
  const Vec3 expected = Vec3(-0.3, 0, 0.8).normalized();
  CHECK(column(document.mesh.vertex_columns, "nx").values[0] == doctest::Approx(expected.x()));
  CHECK(column(document.mesh.vertex_columns, "nz").values[0] == doctest::Approx(expected.z()));
}

TEST_CASE("glb: nodes are joined, and a mesh without colors is white beside one with some") {
  Json json = gltf_tetrahedron();
  json["meshes"].push_back(json["meshes"][0]);
  Bytes colors;
  for (int i = 0; i < 4; ++i) colors.u8(10).u8(20).u8(30).u8(255);
  first_primitive(json)["attributes"]["COLOR_0"] =
      add_accessor(json, colors, 4, 5121, "VEC4", true);
  json["nodes"].push_back({{"mesh", 1}});
  json["scenes"][0]["nodes"] = {0, 1};
  const ReadResult result = read_mesh(json.dump(), "input");
  CHECK(has_note(result.notes, "glb: 2 mesh nodes read as one mesh"));
  CHECK(result.document.mesh.faces[7] == Face{4, 7, 6});
  CHECK(column(result.document.mesh.vertex_columns, "green").values ==
        std::vector<double>{20, 20, 20, 20, 255, 255, 255, 255});
  CHECK(result.document.style.comments == std::vector<std::string>{"tm:unit meter"});
}

TEST_CASE("glb: repeated meshes are refused before they fill the memory") {
  Json json = gltf_tetrahedron();
  json["accessors"][0]["count"] = 400000;
  json["accessors"][0].erase("bufferView");
  json["nodes"] = Json::array();
  json["scenes"][0]["nodes"] = Json::array();
  for (int i = 0; i < 100; ++i) {
    json["nodes"].push_back({{"mesh", 0}});
    json["scenes"][0]["nodes"].push_back(i);
  }
  CHECK(contains(read_error(json.dump()), "repeated parts expand to more than 64 MB"));
}
