/// Finds the faces near a box in a mesh to which faces are added: a few trees (bvh.h), each over at
/// least twice as many faces as the next. Cost: O(log n) amortized to add a face; a search is that
/// of O(log n) trees. Deterministic.
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

  /// Takes in the faces that were added behind those known.
  void update();
  /// Appends the faces whose boxes touch the box, in no particular order; perhaps some that are
  /// just beside it.
  void append_near(const Vec3& low, const Vec3& high, std::vector<Index>& faces) const;

 private:
  struct Tree {
    Index first;  ///< face
    Index count;
    Bvh bvh;
  };

  const Mesh& mesh_;
  BoxFrame frame_;
  std::vector<Tree> trees_;
};

}  // namespace transformesh
