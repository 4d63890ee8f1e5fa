/// A bounding volume hierarchy over boxes, for pairs of overlapping boxes and for queries.
/// Boxes are floats rounded outwards, so no overlap in doubles is missed; leaves are in Morton
/// order of the box centres. Building and the self-traversal run on all allowed threads; results
/// come in an order that does not depend on their number.
/// Cost: O(n log n) to build, about 64 bytes per box.
/// Reference: Karras, "Maximizing parallelism in the construction of BVHs", HPG 2012.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// A box in floats that contains the doubles it was made from.
struct FloatBox {
  std::array<float, 3> minimum;
  std::array<float, 3> maximum;
};
FloatBox float_box(const Vec3& minimum, const Vec3& maximum);

class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(std::span<const FloatBox> boxes);
  /// Over the faces of a mesh, box i around face i.
  explicit Bvh(const Mesh& mesh);

  using Pair = std::pair<Index, Index>;
  /// All pairs of overlapping boxes (touching counts) with first < second that pass `accept`,
  /// sorted. `accept` may be called from several threads at once.
  std::vector<Pair> overlapping_pairs(const std::function<bool(Index, Index)>& accept) const;
  /// All pairs (box here, box there), sorted.
  std::vector<Pair> overlapping_pairs(const Bvh& other,
                                      const std::function<bool(Index, Index)>& accept) const;

  /// Calls visit(i) for every box that overlaps `box`, until it returns false.
  void visit_overlaps(const FloatBox& box, const std::function<bool(Index)>& visit) const;
  /// Calls visit(i, bound) for boxes in order of growing squared distance from the point while that
  /// is below the bound, which visit may lower: for nearest queries.
  void visit_nearest(const Vec3& point, double& bound_squared,
                     const std::function<void(Index)>& visit) const;

  bool empty() const { return nodes_.empty(); }

 private:
  struct Node {
    FloatBox box;
    Index left;  ///< child, or box id where `count` is 1
    Index right;
  };
  std::vector<Node> nodes_;
};

}  // namespace transformesh
