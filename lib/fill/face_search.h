/// Finds the faces near triangles in a mesh to which faces are appended. Maintains several bounding
/// volume hierarchies (bvh.h), each of consecutive faces. Each hierarchy has at least twice as many
/// faces as the next one. Cost: amortized O(log n) to add a face; a search visits O(log n) trees.
/// Deterministic.
#pragma once

#include <vector>

#include "geometry/search/bvh.h"
#include "geometry/search/float_box.h"
#include "mesh/triangle.h"
#include "transformesh/mesh.h"

namespace transformesh {

class FaceSearch {
 public:
  /// Keeps a reference to the mesh.
  explicit FaceSearch(const Mesh& mesh);

  /// Adds the faces that were appended to the mesh since the last call.
  void update();
  /// Returns the faces whose bounding boxes touch the bounding box of one of the triangles, in
  /// ascending order. May also return faces whose boxes are just beside such a box.
  std::vector<Index> near(std::span<const Triangle> triangles) const;

  /// True if some of the triangles intersect each other or a face of the mesh.
  bool intersect(std::span<const Triangle> triangles) const;

 private:
  FloatBox box(const Triangle& triangle) const;

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
