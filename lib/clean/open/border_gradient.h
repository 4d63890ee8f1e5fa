/// Upper bounds of the gradient of the generalized winding number of a surface with borders.
///
/// The gradient at a point is at most an integral over the borders, divided by 4 pi (the law of
/// Biot and Savart). The integrand is the length element divided by its squared distance. Hence the
/// winding number differs by at most the bound times the distance between two points of a box, if
/// no part of the surface is between them. Floating point; deterministic; thread-safe. Cost:
/// O(b log b) to build for b border edges, about O(log b) per box far from the borders.
#pragma once

#include <vector>

#include "transformesh/measure.h"
#include "transformesh/mesh.h"

namespace transformesh {

class BorderGradient {
 public:
  explicit BorderGradient(const Mesh& mesh);

  /// Returns an upper bound of the length of the gradient in a box, in 1 per unit of length.
  /// Infinite if the box touches the box of a border edge.
  double in(const Box& box) const;

 private:
  /// Border edges that are close to each other. Children follow their parent in `nodes_`.
  struct Node {
    Box box{};
    double length = 0;   ///< total length of the edges, with the number of times that they count
    Index second_child;  ///< the first child follows the node; `no_index` if the node is one edge
  };

  Index build(std::vector<Node>& edges, std::size_t first, std::size_t last);
  double from(Index node, const Box& box) const;

  std::vector<Node> nodes_;  ///< the first is the root; empty if there is no border
};

}  // namespace transformesh
