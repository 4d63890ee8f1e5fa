/// Cuts a mesh across its longest side into slabs, so that operations which reach no farther than a
/// few edges run in every second slab at the same time: as the slabs between them are thicker than
/// what two operations reach together, they never meet, and the result is that of one slab after
/// the other. How many slabs there are depends on the mesh alone. Cost: O(n); deterministic.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "tm/remesh/editable_mesh.h"

namespace transformesh {

/// The space between two planes across an axis.
struct MeshSlab {
  Eigen::Index axis = 0;
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
  bool holds(const Vec3& point) const { return point[axis] >= low && point[axis] < high; }
};

class Slabs {
 public:
  /// Four, eight, sixteen and so on with as many vertices each, none thinner than that; one where
  /// four would be thinner or hold few vertices.
  Slabs(const EditableMesh& mesh, double least_thickness);
  /// All in one.
  explicit Slabs(const EditableMesh& mesh);

  std::size_t size() const { return slabs_.size(); }
  const MeshSlab& operator[](std::size_t slab) const { return slabs_[slab]; }
  /// The living vertices that were in there, ascending; they may have moved since.
  const std::vector<Index>& vertices(std::size_t slab) const { return vertices_[slab]; }
  /// The slab of a vertex, wherever it has moved.
  std::size_t of(Index vertex) const { return of_vertex_[vertex]; }

  /// Calls edit(slab) for the first, the third and so on at the same time and then finish(slab) for
  /// them one by one; then the same for the others.
  void for_each(const std::function<void(std::size_t slab)>& edit,
                const std::function<void(std::size_t slab)>& finish) const;

 private:
  void sort_vertices(const EditableMesh& mesh);

  std::vector<MeshSlab> slabs_{MeshSlab{}};
  std::vector<std::vector<Index>> vertices_;
  std::vector<std::uint8_t> of_vertex_;
};

}  // namespace transformesh
