#include "io/formats/gltf_mesh.h"

#include "lib/io/gltf_text.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

ReadResult read(const Json& json) { return read_mesh(json.dump(), "input"); }

}  // namespace

TEST_CASE("gltf: strips, fans and corners without indices") {
  Json json = gltf_tetrahedron();
  first_primitive(json).erase("indices");
  const auto faces_as = [&](int mode) {
    first_primitive(json)["mode"] = mode;
    return read(json).document.mesh.faces;
  };
  CHECK(faces_as(5) == std::vector<Face>{{0, 1, 2}, {1, 3, 2}});
  CHECK(faces_as(6) == std::vector<Face>{{0, 1, 2}, {0, 2, 3}});
  CHECK(faces_as(0).empty());
  first_primitive(json)["mode"] = 4;
  CHECK(contains(read_error(json.dump()), "a primitive of triangles of mesh 0 has 4 corners"));
  first_primitive(json)["mode"] = 9;
  CHECK(contains(read_error(json.dump()), "the unknown mode 9"));
  first_primitive(json)["mode"] = 1;
  CHECK(has_note(read(json).notes, "glb: 1 primitive of lines left out"));
}

TEST_CASE("gltf: indices out of range") {
  Json json = gltf_tetrahedron();
  first_primitive(json)["indices"] =
      add_accessor(json, Bytes().u8(0).u8(1).u8(4), 3, 5121, "SCALAR");
  CHECK(contains(read_error(json.dump()), "corner 2 of mesh 0 has a vertex index out of range"));
}

TEST_CASE("gltf: attributes become columns") {
  Json json = gltf_tetrahedron();
  Bytes colors, numbers, places;
  for (int i = 0; i < 4; ++i) {
    colors.u8(static_cast<std::uint64_t>(i)).u8(20).u8(255).u8(255);
    numbers.f32(0.5F * static_cast<float>(i));
    places.f32(0.25F).f32(static_cast<float>(i));
  }
  Json& attributes = first_primitive(json)["attributes"];
  attributes["COLOR_0"] = add_accessor(json, colors, 4, 5121, "VEC4", true);
  attributes["_QUALITY"] = add_accessor(json, numbers, 4, 5126, "SCALAR");
  attributes["TEXCOORD_0"] = add_accessor(json, places, 4, 5126, "VEC2");
  attributes["JOINTS_0"] = add_accessor(json, colors, 4, 5121, "VEC4");
  const ReadResult result = read(json);
  const Columns& columns = result.document.mesh.vertex_columns;
  CHECK(column(columns, "red").values == std::vector<double>{0, 1, 2, 3});
  CHECK(column(columns, "red").type == Scalar::uint8);
  CHECK(columns.find("alpha") == nullptr);  // all are opaque
  CHECK(column(columns, "quality").values == std::vector<double>{0, 0.5, 1, 1.5});
  CHECK(column(columns, "t").values == std::vector<double>{1, 0, -1, -2});
  CHECK(has_note(result.notes, "glb: 1 vertex attribute of an unsupported type left out"));
  attributes["_QUALITY"] = 1;
  CHECK(contains(read_error(json.dump()), "accessor 1 has 12 elements, too many"));
}

TEST_CASE("gltf: materials color faces, and white stands for none") {
  Json json = gltf_tetrahedron();
  Json other = first_primitive(json);
  json["materials"] =
      Json::array({{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0.2, 1}}}}}});
  other["material"] = 0;
  json["meshes"][0]["primitives"].push_back(other);
  const Mesh mesh = read(json).document.mesh;
  CHECK(mesh.positions.size() == 4);  // both share them
  CHECK(mesh.faces.size() == 8);
  CHECK(column(mesh.face_columns, "green").values ==
        std::vector<double>{255, 255, 255, 255, 0, 0, 0, 0});
  CHECK(column(mesh.face_columns, "blue").values[4] == 51);
  CHECK(read(gltf_tetrahedron()).document.mesh.face_columns.columns.empty());
}

TEST_CASE("gltf: EXT_mesh_manifold makes copies of a vertex one again") {
  Json json = gltf_tetrahedron();
  Bytes corners;
  for (const int corner : {0, 1, 2, 0, 1, 3}) corners.u8(static_cast<std::uint64_t>(corner));
  Bytes merged;
  for (const int corner : {0, 1, 2, 0, 1, 2}) merged.u8(static_cast<std::uint64_t>(corner));
  first_primitive(json)["indices"] = add_accessor(json, corners, 6, 5121, "SCALAR");
  const std::size_t with = add_accessor(json, merged, 6, 5121, "SCALAR");
  json["meshes"][0]["extensions"]["EXT_mesh_manifold"]["manifoldPrimitive"] = {
      {"attributes", {{"POSITION", 0}}}, {"indices", with}};
  const Mesh mesh = read(json).document.mesh;
  CHECK(mesh.positions.size() == 3);
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}, {0, 1, 2}});
  json["meshes"][0]["extensions"]["EXT_mesh_manifold"]["manifoldPrimitive"]["indices"] = 1;
  const ReadResult unfit = read(json);
  CHECK(unfit.document.mesh.positions.size() == 4);
  CHECK(has_note(
      unfit.notes,
      "glb: 1 mesh extension EXT_mesh_manifold that does not match its triangles left out"));
}
