#include "io/formats/gltf_accessor.h"

#include "lib/io/gltf_text.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

/// Returns the numbers of an accessor in a file that contains only this accessor.
GltfNumbers numbers_of(const Json& json, std::size_t accessor) {
  const std::string text = json.dump();
  return gltf_numbers(GltfFile({text, "input"}, ""), accessor, 1000);
}

std::string error_of(const Json& json, std::size_t accessor) {
  try {
    numbers_of(json, accessor);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

}  // namespace

TEST_CASE("gltf: integers that are normalized") {
  Json json = gltf_tetrahedron();
  const auto bytes =
      add_accessor(json, Bytes().u8(0).u8(51).u8(255).u8(128), 4, 5121, "SCALAR", true);
  CHECK(numbers_of(json, bytes).values == std::vector<double>{0, 0.2, 1, 128 / 255.0});
  CHECK(numbers_of(json, bytes).is_byte);
  const auto shorts = add_accessor(json, Bytes().u16(0x8000).u16(0x7fff), 1, 5122, "VEC2", true);
  CHECK(numbers_of(json, shorts).values == std::vector<double>{-1, 1});
  const auto plain = add_accessor(json, Bytes().u16(0xffff), 1, 5123, "SCALAR");
  CHECK(numbers_of(json, plain).values == std::vector<double>{65535});
}

TEST_CASE("gltf: a stride skips bytes, and must not be shorter than an element") {
  Json json = gltf_tetrahedron();
  Bytes bytes;
  bytes.f32(1).u32(0).f32(2).u32(0).f32(3);
  const auto accessor = add_accessor(json, bytes, 3, 5126, "SCALAR");
  json["bufferViews"].back()["byteStride"] = 8;
  CHECK(numbers_of(json, accessor).values == std::vector<double>{1, 2, 3});
  json["accessors"].back()["count"] = 4;
  CHECK(
      contains(error_of(json, accessor), "4 elements reaches beyond its buffer view of 20 bytes"));
  json["bufferViews"].back()["byteStride"] = 2;
  CHECK(contains(error_of(json, accessor), "reaches beyond"));
}

TEST_CASE("gltf: sparse accessors replace elements") {
  Json json = gltf_tetrahedron();
  const auto places = add_accessor(json, Bytes().u8(0).u8(3), 2, 5121, "SCALAR");
  const auto values = add_accessor(json, Bytes().u16(7).u16(9), 2, 5123, "SCALAR");
  const auto view = [&](std::size_t accessor) { return json["accessors"][accessor]["bufferView"]; };
  json["accessors"][1]["count"] = 4;
  json["accessors"][1]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", view(places)}, {"componentType", 5121}}},
      {"values", {{"bufferView", view(values)}}}};
  CHECK(numbers_of(json, 1).values == std::vector<double>{7, 2, 1, 9});
  json["accessors"][1].erase("bufferView");
  CHECK(numbers_of(json, 1).values == std::vector<double>{7, 0, 0, 9});
  json["accessors"][1]["count"] = 3;
  CHECK(contains(error_of(json, 1), "the sparse part of accessor 1 has an index out of range"));
  json["accessors"][1]["count"] = 1;
  CHECK(contains(error_of(json, 1), "larger than the whole"));
}

TEST_CASE("gltf: types and counts that make no sense") {
  Json json = gltf_tetrahedron();
  json["accessors"][0]["type"] = "MAT4";
  CHECK(contains(error_of(json, 0), "'MAT4', not a scalar or a vector"));
  json = gltf_tetrahedron();
  json["accessors"][0]["componentType"] = 5130;
  CHECK(contains(error_of(json, 0), "the unknown type 5130"));
  json["accessors"][0]["count"] = 1001;
  CHECK(contains(error_of(json, 0), "too many"));
}
