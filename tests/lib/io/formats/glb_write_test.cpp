#include <cstring>
#include <nlohmann/json.hpp>

#include "lib/io/bytes.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

/// Reads a file by the standard: a header, a chunk of JSON, and a chunk of bytes to which accessors
/// refer.
struct Glb {
  explicit Glb(const std::string& file) {
    REQUIRE(file.substr(0, 4) == "glTF");
    REQUIRE(u32(file, 4) == 2);
    REQUIRE(u32(file, 8) == file.size());
    const std::uint32_t length = u32(file, 12);
    REQUIRE(length % 4 == 0);
    REQUIRE(file.substr(16, 4) == "JSON");
    json = nlohmann::json::parse(file.substr(20, length));
    if (20 + length == file.size()) return;
    REQUIRE(file.substr(24 + length, 4) == std::string("BIN\0", 4));
    REQUIRE(28 + length + u32(file, 20 + length) == file.size());
    bytes = file.substr(28 + length);
    REQUIRE(json["buffers"][0]["byteLength"] == bytes.size());
  }

  static std::uint32_t u32(const std::string& from, std::size_t at) {
    return load<std::uint32_t>(from, at);
  }

  // The test assumes a little-endian machine.
  template <class T>
  static T load(const std::string& from, std::size_t at) {
    T value;
    std::memcpy(&value, from.substr(at, sizeof(T)).data(), sizeof(T));
    return value;
  }

  const nlohmann::json& primitive() const { return json["meshes"][0]["primitives"][0]; }

  std::vector<double> numbers(std::size_t number) const {
    const auto& accessor = json["accessors"][number];
    const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::map<std::string, std::size_t> widths{
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
    const std::size_t start = view["byteOffset"];
    const std::size_t size =
        accessor["count"].get<std::size_t>() * widths.at(accessor["type"].get<std::string>());
    REQUIRE(start % 4 == 0);
    std::vector<double> values;
    for (std::size_t i = 0; i < size; ++i) {
      const int type = accessor["componentType"];
      values.push_back(type == 5126   ? load<float>(bytes, start + 4 * i)
                       : type == 5125 ? load<std::uint32_t>(bytes, start + 4 * i)
                       : type == 5123 ? load<std::uint16_t>(bytes, start + 2 * i)
                                      : static_cast<unsigned char>(bytes.at(start + i)));
    }
    return values;
  }

  const nlohmann::json& accessor(const std::string& attribute) const {
    return json["accessors"][primitive()["attributes"][attribute].get<std::size_t>()];
  }

  std::vector<double> attribute(const std::string& name) const {
    REQUIRE(primitive()["attributes"].contains(name));
    return numbers(primitive()["attributes"][name]);
  }

  nlohmann::json json;
  std::string bytes;
};

Document glb_document() {
  Document document;
  document.mesh = tetrahedron();
  document.style.format = Format::glb;
  return document;
}

void set_columns(const std::vector<const char*>& names, Scalar type,
                 const std::vector<double>& values, Document& document) {
  for (const char* name : names)
    document.mesh.vertex_columns.get(name, type, values.size()).values = values;
}

}  // namespace

TEST_CASE("glb: positions with their box, and triangles") {
  Document document = glb_document();
  document.mesh.positions[1] = {0.1, -2, 3};
  document.style.comments = {"made by hand", "not \xff UTF-8"};
  const WriteResult result = write_mesh(document);
  CHECK(result.notes == std::vector<std::string>{"glb: coordinates are rounded to float"});
  const Glb glb(result.bytes);
  CHECK(glb.attribute("POSITION") ==
        std::vector<double>{0, 0, 0, static_cast<double>(0.1F), -2, 3, 0, 1, 0, 0, 0, 1});
  CHECK(glb.numbers(glb.primitive()["indices"]) ==
        std::vector<double>{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2});
  const auto& accessor =
      glb.json["accessors"][glb.primitive()["attributes"]["POSITION"].get<std::size_t>()];
  CHECK(accessor["min"] == std::vector<double>{0, -2, 0});
  CHECK(accessor["max"] == std::vector<double>{static_cast<double>(0.1F), 1, 3});
  CHECK(glb.primitive()["mode"] == 4);
  CHECK(glb.json["asset"]["version"] == "2.0");
  CHECK(glb.json["asset"]["extras"]["comments"][0] == "made by hand");
}

TEST_CASE("glb: normals, colors, texture coordinates and other numbers of vertices") {
  Document document = glb_document();
  set_columns({"nx", "ny", "nz"}, Scalar::float32, {0, 0, 3, 1}, document);
  set_columns({"nx"}, Scalar::float32, {2, 1, 4, 0}, document);
  set_columns({"red", "green", "blue"}, Scalar::uint8, {0, 1, 128, 255}, document);
  set_columns({"s", "t"}, Scalar::float64, {0, 0.25, 0.5, 2}, document);
  set_columns({"quality", "Quality"}, Scalar::float64, {0.5, -4, 0, 1}, document);
  set_columns({"far"}, Scalar::float64, {0, 1e300, 0, 1}, document);
  document.mesh.face_columns.get("label", Scalar::int32, 4);
  const WriteResult result = write_mesh(document);
  CHECK(result.notes ==
        std::vector<std::string>{"glb: vertex property 'Quality' cannot be stored in GLB, dropped",
                                 "glb: vertex property 'far' cannot be stored in GLB, dropped",
                                 "glb: face property 'label' cannot be stored in GLB, dropped"});
  const Glb glb(result.bytes);
  const std::vector<double> normals = glb.attribute("NORMAL");
  CHECK(normals[0] == 1);
  CHECK(normals[6] == doctest::Approx(4 / std::sqrt(34.0)));
  CHECK(normals[8] == doctest::Approx(3 / std::sqrt(34.0)));
  CHECK(glb.attribute("COLOR_0") ==
        std::vector<double>{0, 0, 0, 255, 1, 1, 1, 255, 128, 128, 128, 255, 255, 255, 255, 255});
  CHECK(glb.attribute("TEXCOORD_0") == std::vector<double>{0, 1, 0.25, 0.75, 0.5, 0.5, 2, -1});
  CHECK(glb.attribute("_QUALITY") == std::vector<double>{0.5, -4, 0, 1});
}

TEST_CASE(
    "glb: corners of a vertex that differ in the texture make it two; the picture is inside") {
  Document document = glb_document();
  Column& lists = document.mesh.face_columns.get("texcoord", Scalar::float32, 0);
  lists.list_count_type = Scalar::uint8;
  lists.list_offsets = {0, 6, 12, 18, 18};
  // Vertex 1 has another texture coordinate in the third face than in the second. The fourth face
  // has none.
  lists.values = {0, 0, 0.5, 0, 0.25, 0.5, 0, 0, 0.25, 0.5, 1, 1, 0.75, 0.5, 0.5, 0, 1, 1};
  document.texture = "the bytes of a PNG";
  const WriteResult result = write_mesh(document);
  CHECK(result.notes.empty());
  const Glb glb(result.bytes);
  CHECK(glb.numbers(glb.primitive()["indices"]) ==
        std::vector<double>{0, 2, 1, 0, 1, 3, 4, 2, 3, 0, 3, 2});
  CHECK(glb.attribute("POSITION") ==
        std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0});
  CHECK(glb.attribute("TEXCOORD_0") ==
        std::vector<double>{0, 1, 0.25, 0.5, 0.5, 1, 1, 0, 0.75, 0.5});
  const auto& image = glb.json["images"][0];
  const auto& view = glb.json["bufferViews"][image["bufferView"].get<std::size_t>()];
  CHECK(image["mimeType"] == "image/png");
  CHECK(glb.bytes.substr(view["byteOffset"], view["byteLength"]) == document.texture);
  CHECK(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] == 0);
  CHECK(glb.json["extensionsUsed"] ==
        std::vector<std::string>{"EXT_mesh_manifold", "KHR_materials_unlit"});
}

TEST_CASE("glb: notes name texture coordinates that are not stored") {
  Document document = glb_document();
  set_columns({"s", "t"}, Scalar::float64, {0, 0.25, 0.5, 2}, document);
  Column& lists = document.mesh.face_columns.get("texcoord", Scalar::float64, 0);
  lists.list_count_type = Scalar::uint8;
  lists.list_offsets = {0, 6, 6, 6, 6};
  lists.values = {0, 0, 0.5, 0, 0.25, 0.5};
  const auto dropped = [](const std::string& what) {
    return "glb: " + what + " cannot be stored in GLB, dropped";
  };
  CHECK(write_mesh(document).notes ==
        std::vector{dropped("vertex property 's'"), dropped("vertex property 't'")});
  lists.values[2] = 1e300;
  CHECK(write_mesh(document).notes == std::vector{dropped("vertex property 's'"),
                                                  dropped("vertex property 't'"),
                                                  dropped("face property 'texcoord'")});
}

TEST_CASE("glb: closed manifolds are said to be such, with the copies that are one vertex") {
  Document document = glb_document();
  const auto extension_of = [](const Glb& glb) {
    return glb.json["meshes"][0]["extensions"]["EXT_mesh_manifold"];
  };
  const Glb plain(write_mesh(document).bytes);
  const auto primitive = extension_of(plain)["manifoldPrimitive"];
  CHECK(primitive["indices"] == plain.primitive()["indices"]);
  CHECK(primitive["attributes"]["POSITION"] == plain.primitive()["attributes"]["POSITION"]);
  CHECK_FALSE(extension_of(plain).contains("mergeIndices"));

  Column& lists = document.mesh.face_columns.get("texcoord", Scalar::float32, 0);
  lists.list_count_type = Scalar::uint8;
  lists.list_offsets = {0, 6, 12, 18, 18};
  lists.values = {0, 0, 0.5, 0, 0.25, 0.5, 0, 0, 0.25, 0.5, 1, 1, 0.75, 0.5, 0.5, 0, 1, 1};
  const Glb split(write_mesh(document).bytes);
  // The first corner of the third face is a copy of vertex 1.
  CHECK(split.numbers(extension_of(split)["mergeIndices"]) == std::vector<double>{6});
  CHECK(split.numbers(extension_of(split)["mergeValues"]) == std::vector<double>{1});
  const auto& merged =
      split.json["accessors"]
                [extension_of(split)["manifoldPrimitive"]["indices"].get<std::size_t>()];
  CHECK(merged["sparse"]["count"] == 1);

  document.mesh.faces.pop_back();
  document.mesh.face_columns = {};
  CHECK_FALSE(Glb(write_mesh(document).bytes).json.contains("extensionsUsed"));
}

TEST_CASE("glb: integer colors have the scale of their type") {
  Document document = glb_document();
  set_columns({"red", "green", "blue"}, Scalar::uint16, {0, 257, 32768, 65535}, document);
  const Glb fine(write_mesh(document).bytes);
  CHECK(fine.accessor("COLOR_0")["componentType"] == 5123);
  CHECK(fine.accessor("COLOR_0")["normalized"] == true);
  CHECK(fine.attribute("COLOR_0")[4] == 257);
  CHECK(fine.attribute("COLOR_0")[7] == 65535);
  set_columns({"red", "green", "blue"}, Scalar::int32, {0, 1, 128, 255}, document);
  const Glb bytes(write_mesh(document).bytes);
  CHECK(bytes.accessor("COLOR_0")["componentType"] == 5121);
  CHECK(bytes.attribute("COLOR_0")[4] == 1);
}

TEST_CASE("glb: data that the standard cannot hold is noted") {
  Document document = glb_document();
  set_columns({"nx", "ny", "nz"}, Scalar::float32, {0, 1, 1, 1}, document);
  set_columns({"red", "green", "blue"}, Scalar::float64, {0, 0.1, 0.5, 2}, document);
  const WriteResult result = write_mesh(document);
  const Glb glb(result.bytes);
  // Zeros are not normals, and values above 1 are not colors: they are written as named numbers.
  CHECK_FALSE(glb.primitive()["attributes"].contains("NORMAL"));
  CHECK_FALSE(glb.primitive()["attributes"].contains("COLOR_0"));
  CHECK(glb.attribute("_NX") == std::vector<double>{0, 1, 1, 1});
  CHECK(glb.attribute("_RED")[3] == 2);
  CHECK(has_note(result.notes, "glb: vertex property 'red' is rounded to float"));
  document.mesh.positions[0].x() = 1e39;
  CHECK_THROWS_AS(write_mesh(document), GoalError);
}

TEST_CASE("glb: points, and nothing at all") {
  Document document = glb_document();
  document.mesh.faces.clear();
  const Glb points(write_mesh(document).bytes);
  CHECK(points.primitive()["mode"] == 0);
  CHECK_FALSE(points.primitive().contains("indices"));
  document.mesh.positions.clear();
  const Glb empty(write_mesh(document).bytes);
  CHECK(empty.bytes.empty());
  CHECK_FALSE(empty.json.contains("meshes"));
}
