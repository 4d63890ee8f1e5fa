#include "views/hull/grid_cubes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/parallel.h"

namespace transformesh {
namespace {

/// Least distance of a vertex from the ends of the edge on which it lies, as a fraction of the edge
/// length. Larger values give faces of better shape but less accuracy.
constexpr double least_share = 0.05;

/// Four corners of a cube, ordered so that the tetrahedron has positive orientation. Bits 0, 1 and
/// 2 of a corner are its position along x, y and z.
using Tetrahedron = std::array<unsigned, 4>;
constexpr std::array<Tetrahedron, 6> kuhn = {{{{0, 1, 3, 7}},
                                              {{0, 2, 6, 7}},
                                              {{0, 4, 5, 7}},
                                              {{0, 3, 2, 7}},
                                              {{0, 6, 4, 7}},
                                              {{0, 5, 1, 7}}}};

/// Even permutations of the corners of a tetrahedron, which preserve its orientation. `one_first`
/// has one permutation for each choice of the first corner; `two_first` has one for each choice of
/// the first two corners.
constexpr std::array<std::array<unsigned, 4>, 4> one_first = {
    {{{0, 1, 2, 3}}, {{1, 0, 3, 2}}, {{2, 3, 0, 1}}, {{3, 2, 1, 0}}}};
constexpr std::array<std::array<unsigned, 4>, 6> two_first = {{{{0, 1, 2, 3}},
                                                               {{0, 2, 3, 1}},
                                                               {{0, 3, 1, 2}},
                                                               {{1, 2, 0, 3}},
                                                               {{1, 3, 2, 0}},
                                                               {{2, 3, 0, 1}}}};

class Cube {
 public:
  explicit Cube(const GridCube& cube) : node_(cube.nodes) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      is_inside_[corner] = cube.values[corner] < 0;
      is_known_[corner] = !std::isnan(cube.values[corner]);
      inside_count_ += is_inside_[corner] ? 1 : 0;
    }
  }

  void cut(std::vector<EdgeKeyFace>& faces) const {
    if (inside_count_ == 0 || inside_count_ == 8) return;
    for (const Tetrahedron& tetrahedron : kuhn)
      if (std::all_of(tetrahedron.begin(), tetrahedron.end(), [&](auto c) { return is_known_[c]; }))
        cut(tetrahedron, faces);
  }

 private:
  void cut(const Tetrahedron& t, std::vector<EdgeKeyFace>& faces) const {
    const auto inside = std::count_if(t.begin(), t.end(), [&](auto c) { return is_inside_[c]; });
    if (inside == 1) cut_off(t, true, faces);
    if (inside == 3) cut_off(t, false, faces);
    if (inside == 2) cut_across(t, faces);
  }

  /// Adds the triangle that separates the only corner with `is_inside_ == side` from the others.
  void cut_off(const Tetrahedron& t, bool side, std::vector<EdgeKeyFace>& faces) const {
    for (const auto& order : one_first) {
      if (is_inside_[t[order[0]]] != side) continue;
      EdgeKeyFace face;
      for (unsigned i = 0; i < 3; ++i) face[i] = key(t[order[0]], t[order[i + 1]]);
      if (!side) std::swap(face[1], face[2]);
      faces.push_back(face);
    }
  }

  /// Adds two triangles that separate the two corners inside from the two corners outside.
  void cut_across(const Tetrahedron& t, std::vector<EdgeKeyFace>& faces) const {
    for (const auto& order : two_first) {
      const std::array<unsigned, 4> c = {t[order[0]], t[order[1]], t[order[2]], t[order[3]]};
      if (is_inside_[c[0]] != is_inside_[c[1]] || !is_inside_[c[0]]) continue;
      const std::array<EdgeKey, 4> ring = {key(c[0], c[2]), key(c[0], c[3]), key(c[1], c[3]),
                                           key(c[1], c[2])};
      faces.push_back({ring[0], ring[1], ring[2]});
      faces.push_back({ring[0], ring[2], ring[3]});
    }
  }

  /// Returns the key of the edge between corners `a` and `b` of one tetrahedron. In Kuhn's
  /// subdivision, the bits of one corner are a subset of the bits of the other. The edge thus
  /// starts at corner `a & b` and extends along the axes `a ^ b`.
  EdgeKey key(unsigned a, unsigned b) const { return node_[a & b] * 8 + (a ^ b); }

  std::array<std::size_t, 8> node_{};
  std::array<bool, 8> is_inside_{};
  std::array<bool, 8> is_known_{};
  int inside_count_ = 0;
};

Vec3 crossing(const NodeGrid& grid, EdgeKey key,
              const std::function<float(std::size_t node)>& value) {
  const std::size_t start = key / 8;
  const std::array<std::size_t, 3> direction = {key & 1, key >> 1 & 1, key >> 2 & 1};
  const double a = value(start);
  const double b = value(start + grid.index(direction[0], direction[1], direction[2]));
  const double share = std::clamp(a / (a - b), least_share, 1 - least_share);
  const std::array<std::size_t, 3> site = {start % grid.nodes[0],
                                           start / grid.nodes[0] % grid.nodes[1],
                                           start / grid.nodes[0] / grid.nodes[1]};
  Vec3 position = grid.origin;
  for (int axis = 0; axis < 3; ++axis) {
    position[axis] += grid.spacing * (static_cast<double>(site[axis]) +
                                      share * static_cast<double>(direction[axis]));
  }
  return position;
}

}  // namespace

void cut_cube(const GridCube& cube, std::vector<EdgeKeyFace>& faces) { Cube(cube).cut(faces); }

Mesh mesh_of_cut_edges(const NodeGrid& grid, const std::vector<EdgeKeyFace>& faces,
                       const std::function<float(std::size_t node)>& value) {
  Mesh mesh;
  std::vector<EdgeKey> keys;
  keys.reserve(3 * faces.size());
  for (const EdgeKeyFace& face : faces) keys.insert(keys.end(), face.begin(), face.end());
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  for (const EdgeKey key : keys) mesh.positions.push_back(crossing(grid, key, value));

  mesh.faces.resize(faces.size());
  parallel_for(faces.size(), 4096, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto at = std::lower_bound(keys.begin(), keys.end(), faces[f][corner]);
        mesh.faces[f][corner] = static_cast<Index>(at - keys.begin());
      }
    }
  });
  return mesh;
}

}  // namespace transformesh
