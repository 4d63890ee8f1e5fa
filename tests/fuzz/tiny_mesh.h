/// Makes meshes of few faces from the bytes of a fuzzer. Coordinates are difficult: from a small
/// lattice, a few spacings apart, with many digits, or of magnitudes from 2^-32 to 2^32. Also makes
/// the bytes of initial meshes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "fuzz/fuzz.h"
#include "transformesh/mesh_io.h"

namespace transformesh::fuzz {

inline constexpr std::size_t most_vertices = 24;
inline constexpr std::size_t most_faces = 30;

/// `plain` coordinates are 0 to 15, or multiples of 1 / 37 below 7. `any` also includes coordinates
/// that are so close together, or so large, that rounding matters.
enum class Coordinates { any, plain };

inline double coordinate(Choices& choices, Coordinates coordinates) {
  unsigned kind = choices.below(8);
  if (coordinates == Coordinates::plain && kind != 5) kind = 0;
  const int value = choices.byte();
  switch (kind) {
    case 4:
      return (value & 3) + 0x1p-50 * ((value >> 2) % 16 - 8);
    case 5:
      return value / 37.0;
    case 6:
      return std::ldexp(1 + 0.25 * (value & 3), (value >> 2) - 32);
    case 7:
      return -std::ldexp(1 + 0.25 * (value & 3), (value >> 2) - 32);
    default:
      return value % 16;
  }
}

/// Shows the mesh of a finding as OFF.
inline void show(const Mesh& mesh) {
  Document document;
  document.mesh = mesh;
  document.style.format = Format::off;
  input_text = write_mesh(document).bytes;
}

/// Two bytes encode the numbers of vertices and faces, two each coordinate, and one each corner.
inline Mesh tiny_mesh(Choices& choices, Coordinates coordinates = Coordinates::any) {
  Mesh mesh;
  const unsigned vertices = 1 + choices.below(most_vertices);
  const unsigned faces = 1 + choices.below(most_faces);
  for (unsigned v = 0; v < vertices; ++v) {
    Vec3& position = mesh.positions.emplace_back();
    for (double& x : position) x = coordinate(choices, coordinates);
  }
  for (unsigned f = 0; f < faces && !choices.is_empty(); ++f) {
    const Index a = choices.below(vertices), b = choices.below(vertices);
    mesh.faces.push_back({a, b, choices.below(vertices)});
  }
  show(mesh);
  return mesh;
}

/// Returns the bytes of a mesh whose vertices are rounded to the lattice; empty if the mesh is too
/// large.
inline std::string tiny_mesh_bytes(const Mesh& mesh) {
  if (mesh.positions.size() > most_vertices || mesh.faces.size() > most_faces) return {};
  if (mesh.positions.empty() || mesh.faces.empty()) return {};
  Vec3 low = mesh.positions[0], high = low;
  for (const Vec3& p : mesh.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double scale = 15 / std::max((high - low).maxCoeff(), 1e-300);
  std::string bytes = {static_cast<char>(mesh.positions.size() - 1),
                       static_cast<char>(mesh.faces.size() - 1)};
  for (const Vec3& p : mesh.positions)
    for (const double x : Vec3((p - low) * scale))
      bytes += {'\0', static_cast<char>(std::clamp(std::round(x), 0.0, 15.0))};
  for (const Face& face : mesh.faces)
    for (const Index corner : face) bytes += static_cast<char>(corner);
  return bytes;
}

/// Returns whether every edge, by the positions of its ends, is traversed equally often in both
/// directions, so that winding numbers are integers. Faces that use a position twice are ignored.
inline bool is_closed_by_position(const Mesh& mesh) {
  using Key = std::array<double, 3>;
  const auto key = [&](Index v) {
    const Vec3 p = mesh.positions[v] + Vec3::Zero();  // no -0
    return Key{p.x(), p.y(), p.z()};
  };
  std::map<std::pair<Key, Key>, int> surplus;
  for (const Face& face : mesh.faces) {
    const std::array<Key, 3> corners = {key(face[0]), key(face[1]), key(face[2])};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Key& from = corners[i];
      const Key& to = corners[(i + 1) % 3];
      from < to ? ++surplus[{from, to}] : --surplus[{to, from}];
    }
  }
  return std::all_of(surplus.begin(), surplus.end(), [](const auto& e) { return e.second == 0; });
}

}  // namespace transformesh::fuzz
