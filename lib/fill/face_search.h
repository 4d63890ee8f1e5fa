/// Finds the faces near a box in a mesh that grows. Maintains several bounding volume hierarchies
/// (bvh.h). Each hierarchy has at least twice as many faces as the next hierarchy. Cost: amortized
/// O(log n) to add a face; a search visits O(log n) trees. Deterministic.
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
  /// Appends the faces whose boxes touch the given box, unordered. May also append faces whose
  /// boxes are just beside the given box.
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
