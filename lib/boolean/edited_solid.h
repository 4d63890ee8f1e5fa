/// A solid that is edited many times, a few faces at a time. Removed faces stay in the array of
/// faces and are marked; new faces are appended. Hence the cost of an edit is proportional to the
/// number of removed and added faces. Deterministic.
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

  /// Returns the stored mesh, which contains removed faces and vertices that no face uses.
  const Mesh& mesh() const { return mesh_; }
  /// Returns the number of faces that are not removed.
  std::size_t faces() const { return mesh_.faces.size() - gone_; }
  /// Returns the faces whose bounding boxes touch `box`, ascending. Cost: O(n) with a small factor:
  /// consecutive faces are usually neighbors, so that most blocks of faces are skipped.
  std::vector<Index> faces_touching(const Box& box) const;

  /// Returns the winding number at a point, found by rays along the three axes. Returns nothing if
  /// rounding errors leave the results of all three rays undecided, which happens only near the
  /// surface.
  std::optional<int> winding_at(const Vec3& point) const;

  /// Removes the faces `removed`, and appends the faces of `added`, which must have the same
  /// columns as the solid. `vertex_of` maps each vertex of `added` to a vertex of the solid, or to
  /// no_index if it is new.
  void replace(const std::vector<Index>& removed, const Mesh& added, std::vector<Index> vertex_of);

  /// Returns the solid without the removed faces, and leaves this object empty.
  Mesh take();

 private:
  void index_faces();
  void add_box(const Face& face);
  void append_vertices(const Mesh& added, std::vector<Index>& vertex_of);
  FloatBox box_of(const Face& face) const;

  Mesh mesh_;
  BoxFrame frame_;
  std::vector<FloatBox> boxes_;   ///< bounding box of each face; empty if the face is removed
  std::vector<FloatBox> blocks_;  ///< bounding box of each block of `block_size` faces
  std::size_t gone_ = 0;          ///< number of removed faces
};

}  // namespace transformesh
