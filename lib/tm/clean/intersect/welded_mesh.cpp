#include "tm/clean/intersect/welded_mesh.h"

#include <algorithm>
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

// A hash table with open addressing, whose slots hold points.
void number_points(const Mesh& mesh, WeldedMesh& welded) {
  const std::size_t size = std::bit_ceil(2 * mesh.positions.size() + 1);
  std::vector<Index> slots(size, no_index);
  welded.point_of.reserve(mesh.positions.size());
  for (Index vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const Vec3& position = mesh.positions[vertex];
    std::size_t slot = hash(position) & (size - 1);
    while (slots[slot] != no_index && welded.points[slots[slot]] != position) {
      slot = (slot + 1) & (size - 1);
    }
    if (slots[slot] == no_index) {
      slots[slot] = static_cast<Index>(welded.points.size());
      welded.points.emplace_back(position + Vec3::Zero());
      welded.vertex_of.push_back(vertex);
    }
    welded.point_of.push_back(slots[slot]);
  }
}

Face sorted(Face face) {
  std::sort(face.begin(), face.end());
  return face;
}

std::uint64_t hash(const Face& face) {
  std::uint64_t h = 0x9e3779b97f4a7c15ULL;
  for (const Index point : face) {
    h = (h ^ point) * 0xff51afd7ed558ccdULL;
    h ^= h >> 32;
  }
  return h;
}

bool is_degenerate(const WeldedMesh& welded, const Face& face) {
  return is_collapsed(face) ||
         collinear(welded.points[face[0]], welded.points[face[1]], welded.points[face[2]]);
}

}  // namespace

WeldedMesh weld(const Mesh& mesh) {
  WeldedMesh welded;
  number_points(mesh, welded);
  welded.frame = BoxFrame(welded.points);
  welded.faces.reserve(mesh.faces.size());
  welded.face_of.reserve(mesh.faces.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Face& corners = mesh.faces[f];
    const Face face{welded.point_of[corners[0]], welded.point_of[corners[1]],
                    welded.point_of[corners[2]]};
    if (is_degenerate(welded, face)) continue;
    welded.faces.push_back(face);
    welded.face_of.push_back(f);
  }
  find_copies(welded);
  return welded;
}

void find_copies(WeldedMesh& welded) {
  const std::size_t size = std::bit_ceil(2 * welded.faces.size() + 1);
  std::vector<Index> slots(size, no_index);
  welded.first_copy.resize(welded.faces.size());
  for (Index f = 0; f < welded.faces.size(); ++f) {
    const Face key = sorted(welded.faces[f]);
    std::size_t slot = hash(key) & (size - 1);
    while (slots[slot] != no_index && sorted(welded.faces[slots[slot]]) != key) {
      slot = (slot + 1) & (size - 1);
    }
    if (slots[slot] == no_index) slots[slot] = f;
    welded.first_copy[f] = slots[slot];
  }
}

}  // namespace transformesh
