#include "clean/intersect/disjoint_faces.h"

#include <algorithm>

#include "mesh/position_hash.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

// The sum does not depend on the order of the corners.
std::uint64_t hash(const Triangle& t) {
  return position_hash(t[0]) + position_hash(t[1]) + position_hash(t[2]);
}

bool has_same_corners(const Triangle& a, const Triangle& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin());
}

}  // namespace

DisjointFaces::DisjointFaces(const Mesh& mesh, std::span<const Index> faces)
    : numbers_(faces.size()) {
  triangles_.reserve(faces.size());
  for (const Index face : faces) {
    const Triangle t = triangle_of(mesh.positions, mesh.faces[face]);
    triangles_.push_back(t);
    numbers_.find_or_insert(hash(t), static_cast<Index>(triangles_.size() - 1),
                            [&](Index i) { return has_same_corners(triangles_[i], t); });
  }
}

std::vector<char> DisjointFaces::find(const std::vector<Vec3>& points,
                                      const std::vector<Face>& faces) const {
  std::vector<char> is_stored(faces.size(), 0);
  if (empty()) return is_stored;
  parallel_for_each(faces.size(), [&](std::size_t f) {
    const Triangle t = triangle_of(points, faces[f]);
    const auto is_same = [&](Index i) { return has_same_corners(triangles_[i], t); };
    is_stored[f] = numbers_.find(hash(t), is_same) == no_index ? 0 : 1;
  });
  return is_stored;
}

}  // namespace transformesh
