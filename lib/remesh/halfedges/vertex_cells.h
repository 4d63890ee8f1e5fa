/// A grid of the vertices of a mesh with normal cones of their faces, for the embedding guard. Used
/// cells are stored in a hash table. With a FaceTree in place of the cells, remeshing of meshes
/// with edges of about one length takes 1.14 to 1.9 times as long, decimation 1.18 times.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"
#include "remesh/halfedges/normal_cone.h"

namespace transformesh {

/// Returns for each vertex the lowest vertex of its component; no_index if the component has a
/// border. O(n).
std::vector<Index> closed_components(const EditableMesh& mesh);

class VertexCells {
 public:
  struct Cell {
    std::int64_t key;
    NormalCone cone;         ///< cone of all faces at the cell's vertices
    NormalCone cone_around;  ///< cone of the 27 cells around; empty near other components
    Index first_vertex;
    Index component;
  };
  /// Data of a vertex, stored together for locality.
  struct Vertex {
    Index cell = no_index;
    Index next = no_index;  ///< next vertex in the cell
    Index previous = no_index;
    Index component = no_index;        ///< label of closed_components()
    NormalCone cone = all_directions;  ///< cone of all faces at the vertex
    /// Bound for the squared length of edges of these faces; measured only if the mesh has sizes.
    float longest_squared = HUGE_VALF;
  };

  /// Keeps a reference to the mesh. Finds components if the mesh has no labels. Enlarges cells if
  /// there would be too many for a key.
  VertexCells(const EditableMesh& mesh, double cell_size);

  double cell_size() const { return cell_size_; }
  const Vertex& operator[](Index vertex) const { return vertices_[vertex]; }
  const Cell& cell_of(Index vertex) const { return cells_[vertices_[vertex].cell]; }

  /// Call after a vertex has moved.
  void update(Index vertex);
  /// Call before a vertex is removed.
  void remove(Index vertex);
  /// Call if faces at these vertices are replaced by faces with this cone and this longest edge.
  void restrict(std::span<const Index> vertices, NormalCone cone, double longest_squared);

  /// Calls visit(cell) for the cells that meet a box until it returns false. Returns false if it
  /// did.
  template <class Visit>
  bool for_each_cell_near(const Vec3& low, const Vec3& high, const Visit& visit) const;

 private:
  struct CellsAround {
    Index count = 0;
    std::array<Index, 27> cells;
  };
  using Key = std::int64_t;
  static constexpr int key_bits = 21;  ///< bits of a key per axis
  /// Differences between the key of a cell and those of the 26 cells around it; negative ones
  /// first.
  static constexpr std::array<Key, 26> offsets_around = [] {
    std::array<Key, 26> offsets{};
    std::size_t count = 0;
    for (int i = 0; i < 27; ++i) {
      const Key x = i / 9 - 1, y = i / 3 % 3 - 1, z = i % 3 - 1;
      const Key offset = x * (Key{1} << (2 * key_bits)) + y * (Key{1} << key_bits) + z;
      if (offset != 0) offsets[count++] = offset;
    }
    return offsets;
  }();

  Key key_of(const Vec3& position) const;
  static std::size_t slot_of(Key key) {
    return (static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15ULL) >> 32;
  }
  Index find_cell(Key key) const;
  Index make_cell(Key key, Index component);
  void enter_in_table(Index cell);
  void grow_table();
  /// Calls visit(cell) for the 27 cells around a cell, including the cell itself.
  template <class Visit>
  void for_each_cell_around(Index cell, const Visit& visit) const;
  void fill(std::span<const NormalCone> cones);  ///< `cones`: cone of each face
  void find_cells_around(Index cell, std::span<const Key> offsets);
  void restrict_to_faces(std::span<const NormalCone> cones);
  void dilate(Index cell);
  void measure_edges();
  void stretch(Index vertex, double longest_squared);
  void restrict_cell(Index cell, NormalCone cone);
  void change_cell(Index vertex, Key key);
  void insert(Index vertex, Index cell);

  const EditableMesh& mesh_;
  double cell_size_;
  Vec3 origin_ = Vec3::Zero();
  std::vector<Cell> cells_;
  std::vector<CellsAround> around_;  ///< per cell: the cell and its existing neighbors
  std::vector<Index> table_;         ///< hash table with open addressing; no_index if empty
  std::vector<Vertex> vertices_;     ///< data of each vertex
};

inline Index VertexCells::find_cell(Key key) const {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t slot = slot_of(key);; ++slot) {
    const Index cell = table_[slot & mask];
    if (cell == no_index || cells_[cell].key == key) return cell;
  }
}

template <class Visit>
bool VertexCells::for_each_cell_near(const Vec3& low, const Vec3& high, const Visit& visit) const {
  const Key first = key_of(low);
  const Key last = key_of(high);
  constexpr Key axis_mask = (Key{1} << key_bits) - 1;
  for (Key x = first >> (2 * key_bits); x <= last >> (2 * key_bits); ++x) {
    for (Key y = (first >> key_bits) & axis_mask; y <= ((last >> key_bits) & axis_mask); ++y) {
      for (Key z = first & axis_mask; z <= (last & axis_mask); ++z) {
        const Index cell = find_cell((x << (2 * key_bits)) | (y << key_bits) | z);
        if (cell != no_index && !visit(cells_[cell])) return false;
      }
    }
  }
  return true;
}

}  // namespace transformesh
