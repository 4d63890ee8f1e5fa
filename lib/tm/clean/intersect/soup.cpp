#include "tm/clean/intersect/soup.h"

#include <bit>

namespace transformesh {
namespace {

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = 0x9e3779b97f4a7c15ULL;
  for (int i = 0; i < 3; ++i) {
    h ^= std::bit_cast<std::uint64_t>(p[i] + 0.0);  // the sum turns -0 into 0
    h *= 0xff51afd7ed558ccdULL;
    h ^= h >> 32;
  }
  return h;
}

// Open addressing; a slot holds a point. Points come in order of their first vertex.
void weld_positions(const Mesh& mesh, Soup& soup) {
  const std::size_t size = std::bit_ceil(2 * mesh.positions.size() + 1);
  std::vector<Index> slots(size, no_index);
  soup.point_of.reserve(mesh.positions.size());
  for (Index vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const Vec3& position = mesh.positions[vertex];
    std::size_t slot = hash(position) & (size - 1);
    while (slots[slot] != no_index && soup.points[slots[slot]] != position) {
      slot = (slot + 1) & (size - 1);
    }
    if (slots[slot] == no_index) {
      slots[slot] = static_cast<Index>(soup.points.size());
      soup.points.emplace_back(position + Vec3::Zero());
      soup.vertex_of.push_back(vertex);
    }
    soup.point_of.push_back(slots[slot]);
  }
}

bool is_degenerate(const Soup& soup, const Face& face) {
  return is_collapsed(face) ||
         collinear(soup.points[face[0]], soup.points[face[1]], soup.points[face[2]]);
}

}  // namespace

Soup make_soup(const Mesh& mesh) {
  Soup soup;
  weld_positions(mesh, soup);
  soup.frame = BoxFrame(soup.points);
  soup.faces.reserve(mesh.faces.size());
  soup.face_of.reserve(mesh.faces.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Face& corners = mesh.faces[f];
    const Face face{soup.point_of[corners[0]], soup.point_of[corners[1]],
                    soup.point_of[corners[2]]};
    if (is_degenerate(soup, face)) continue;
    soup.faces.push_back(face);
    soup.face_of.push_back(f);
  }
  return soup;
}

}  // namespace transformesh
