#include "io/formats/gltf_file.h"

#include <filesystem>
#include <fstream>

#include "helpers/temporary_folder.h"
#include "lib/io/gltf_text.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

std::string glb_of(const std::string& json, const std::string& binary) {
  Bytes bytes;
  bytes.text("glTF").u32(2).u32(12 + 8 + json.size() + 8 + binary.size());
  bytes.u32(json.size()).text("JSON").text(json);
  bytes.u32(binary.size()).text(std::string("BIN\0", 4)).text(binary);
  return bytes.str();
}

std::string text_of_size(std::string text) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  return text;
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("gltf: the container, and its damages") {
  Json json = gltf_tetrahedron();
  json["buffers"][0].erase("uri");
  Bytes binary;
  for (int i = 0; i < 12; ++i) binary.f32(static_cast<float>(i));
  for (int i = 0; i < 12; ++i) binary.u16(static_cast<std::uint64_t>(i % 4));
  const std::string bytes = glb_of(text_of_size(json.dump()), binary.str());
  CHECK(read_document(bytes).mesh.positions[3] == Vec3(9, 10, 11));
  CHECK(contains(read_error(bytes.substr(0, bytes.size() - 1)), "cut off"));
  CHECK(contains(read_error(bytes.substr(0, 10)), "cut off in a header"));
  std::string old = bytes;
  old[4] = 1;
  CHECK(contains(read_error(old), "version 1"));
  std::string long_chunk = bytes;
  long_chunk[14] = 1;
  CHECK(contains(read_error(long_chunk), "a GLB chunk extends beyond the end"));
  CHECK(read_error(glb_of("{\"asset\": [}", "")) == "the glTF JSON is malformed (input byte 31)");
  CHECK(has_note(read_mesh(bytes + "xy", "input").notes,
                 "glb: 2 bytes after the last chunk ignored"));
}

TEST_CASE("gltf: extensions that are required are known or refused by name") {
  const auto error_with = [](const char* extension) {
    Json json = gltf_tetrahedron();
    json["extensionsRequired"] = {extension};
    return read_error(json.dump());
  };
  CHECK(error_with("KHR_materials_unlit") == "read");
  CHECK(contains(error_with("KHR_draco_mesh_compression"), "compressed by Draco"));
  CHECK(contains(error_with("EXT_meshopt_compression"), "compressed by meshopt"));
  CHECK(contains(error_with("EXT_mesh_gpu_instancing"), "'EXT_mesh_gpu_instancing'"));
}

TEST_CASE("gltf: missing buffers are refused") {
  Json json = gltf_tetrahedron();
  json["buffers"][0]["byteLength"] = 73;
  CHECK(contains(read_error(json.dump()), "buffer 0 announces 73 bytes, but there are 72"));
  json = gltf_tetrahedron();
  json["bufferViews"][1]["byteOffset"] = 49;
  CHECK(contains(read_error(json.dump()), "bufferView 1 reaches beyond its buffer of 72 bytes"));
  json["bufferViews"][1]["byteOffset"] = -1;
  CHECK(contains(read_error(json.dump()), "'byteOffset' of bufferView 1 is not a whole number"));
  json = gltf_tetrahedron();
  json["buffers"][0]["uri"] = "data:;base64,@@";
  CHECK(contains(read_error(json.dump()), "not base64"));
  json["buffers"][0].erase("uri");
  CHECK(contains(read_error(json.dump()), "buffer 0 has no data"));
  json = gltf_tetrahedron();
  json["meshes"][0]["primitives"][0]["indices"] = 7;
  CHECK(contains(read_error(json.dump()), "element 7 of accessors is used, but there are 2"));
  CHECK(contains(read_error("{\"asset\": {\"version\": \"1.0\"}}"),
                 "version '1.0' is not supported"));
}

TEST_CASE("gltf: files beside the file, and none elsewhere") {
  const test::TemporaryFolder outside;
  const std::string folder = outside / "in";
  std::filesystem::create_directory(folder);
  Bytes bytes;
  for (int i = 0; i < 18; ++i) bytes.u32(0);
  write(folder + "/a b.bin", bytes.str());
  write(outside / "secret.bin", bytes.str());
  std::filesystem::create_symlink(outside / "secret.bin", folder + "/link.bin");
  const auto error_of = [&](const std::string& uri, const std::string& where) {
    Json json = gltf_tetrahedron();
    json["buffers"][0]["uri"] = uri;
    return read_error(json.dump(), "input", {.folder = where});
  };
  CHECK(error_of("a%20b.bin", folder) == "read");
  CHECK(contains(error_of("a%20b.bin", ""), "given by its file name"));
  CHECK(contains(error_of("none.bin", folder), "'none.bin' is missing beside the file"));
  for (const std::string& uri : {std::string("../secret.bin"), std::string("link.bin"),
                                 outside / "secret.bin", std::string("http://host/a.bin")})
    CHECK(contains(error_of(uri, folder), "is not in the folder of the file"));
}
