/// Files of glTF written by hand: JSON with its buffer as a data URI. The bytes are converted to
/// base64 bit by bit, without the library.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lib/io/bytes.h"

namespace transformesh::testing {

using Json = nlohmann::json;

inline std::string base64_by_bits(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bits, text;
  for (const char c : bytes)
    for (int i = 7; i >= 0; --i) bits += ((c >> i) & 1) != 0 ? '1' : '0';
  bits.resize((bits.size() + 5) / 6 * 6, '0');
  for (std::size_t i = 0; i < bits.size(); i += 6)
    text += digits[std::stoul(bits.substr(i, 6), nullptr, 2)];
  return text + std::string((4 - text.size() % 4) % 4, '=');
}

/// A tetrahedron in one node: accessor 0 has four positions, accessor 1 twelve indices.
inline Json gltf_tetrahedron() {
  const Mesh mesh = tetrahedron();
  Bytes bytes;
  for (const Vec3& position : mesh.positions)
    for (const double x : position) bytes.f32(static_cast<float>(x));
  for (const Face& face : mesh.faces)
    for (const Index corner : face) bytes.u16(corner);
  Json json;
  json["asset"] = {{"version", "2.0"}};
  json["scene"] = 0;
  json["scenes"] = Json::array({{{"nodes", {0}}}});
  json["nodes"] = Json::array({{{"mesh", 0}}});
  json["meshes"] = Json::array(
      {{{"primitives", Json::array({{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}})}}});
  json["accessors"] = Json::array(
      {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
       {{"bufferView", 1}, {"componentType", 5123}, {"count", 12}, {"type", "SCALAR"}}});
  json["bufferViews"] = Json::array({{{"buffer", 0}, {"byteLength", 48}},
                                     {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 24}}});
  json["buffers"] = Json::array(
      {{{"byteLength", 72},
        {"uri", "data:application/octet-stream;base64," + base64_by_bits(bytes.str())}}});
  return json;
}

/// Appends numbers as a new buffer, and returns the number of their accessor.
inline std::size_t add_accessor(Json& json, const Bytes& bytes, std::size_t count, int type,
                                const std::string& shape, bool is_normalized = false) {
  json["buffers"].push_back(
      {{"byteLength", bytes.str().size()}, {"uri", "data:;base64," + base64_by_bits(bytes.str())}});
  json["bufferViews"].push_back(
      {{"buffer", json["buffers"].size() - 1}, {"byteLength", bytes.str().size()}});
  json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                               {"componentType", type},
                               {"count", count},
                               {"type", shape},
                               {"normalized", is_normalized}});
  return json["accessors"].size() - 1;
}

inline Json& first_primitive(Json& json) { return json["meshes"][0]["primitives"][0]; }

}  // namespace transformesh::testing
