/// Finds the faces near a box in a mesh to which faces are appended. Maintains several bounding
/// volume hierarchies (bvh.h), each of consecutive faces. Each hierarchy has at least twice as many
/// faces as the next one. Cost: amortized O(log n) to add a face; a search visits O(log n) trees.
/// Deterministic.
#pragma once

#include <vector>

#include "geometry/search/bvh.h"
#include "geometry/search/float_box.h"
#include "transformesh/mesh.h"

namespace transformesh {

class FaceSearch {
 public:
  /// Keeps a reference to the mesh.
  explicit FaceSearch(const Mesh& mesh);

  /// Adds the faces that were appended to the mesh since the last call.
  void update();
  /// Appends to `faces` the faces whose bounding boxes touch the box from `low` to `high`,
  /// unordered. May also append faces whose boxes are just beside this box.
  void append_near(const Vec3& low, const Vec3& high, std::vector<Index>& faces) const;

 private:
  struct Tree {
    Index first;  ///< index of the first face of the tree
    Index count;
    Bvh bvh;
  };

  const Mesh& mesh_;
  BoxFrame frame_;
  std::vector<Tree> trees_;
};

}  // namespace transformesh
