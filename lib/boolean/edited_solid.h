/// A solid that is changed in places, many times. Faces that go leave gaps, and new ones follow, so
/// that a change costs no more than the faces that it concerns. Deterministic.
#pragma once

#include <optional>
#include <vector>

#include "geometry/search/float_box.h"
#include "transformesh/measure.h"
#include "transformesh/mesh.h"

namespace transformesh {

class EditedSolid {
 public:
  explicit EditedSolid(Mesh mesh);

  /// Has faces that are gone, and vertices that no face uses.
  const Mesh& mesh() const { return mesh_; }
  std::size_t faces() const { return mesh_.faces.size() - gone_; }
  /// The faces whose boxes touch this box, ascending. Cost: O(n) with a small factor, as faces that
  /// follow each other are usually neighbors.
  std::vector<Index> faces_touching(const Box& box) const;

  /// The winding number at a point, from a ray. Empty near the surface.
  std::optional<int> winding_at(const Vec3& point) const;

  /// Faces go, and those of another mesh follow. `vertex_of` has the vertex of the solid for each
  /// vertex of that mesh, or no_index for a new one. Both have the same columns.
  void replace(const std::vector<Index>& removed, const Mesh& added, std::vector<Index> vertex_of);

  /// The solid without gaps; this one is empty then.
  Mesh take();

 private:
  void index_faces();
  void add_box(const Face& face);
  void append_vertices(const Mesh& added, std::vector<Index>& vertex_of);
  FloatBox box_of(const Face& face) const;

  Mesh mesh_;
  BoxFrame frame_;
  std::vector<FloatBox> boxes_;   ///< per face; empty if it is gone
  std::vector<FloatBox> blocks_;  ///< around the boxes of as many faces as a block has
  std::size_t gone_ = 0;          ///< faces
};

}  // namespace transformesh
