/// The Laplace-Beltrami operator of a mesh by cotangents over mixed areas.
/// Reference: Meyer, Desbrun, Schroeder & Barr, "Discrete differential-geometry operators for
/// triangulated 2-manifolds", Visualization and Mathematics III, 2003. Differences: angles count as
/// 5 to 175 degrees, and the weight of an edge as at least 0, so that no step is unbounded and
/// implicit steps keep every vertex inside of the convex hull. O(n); deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// The Laplacian of a function f at vertex v is the sum over its edges of
/// weight * (f(neighbor) - f(v)), divided by 2 * areas[v].
struct CotangentLaplacian {
  struct WeightedEdge {
    Index from = 0;
    Index to = 0;
    double weight = 0;  ///< sum of the cotangents opposite of the edge; at least 0
  };

  std::vector<WeightedEdge> edges;  ///< in the order of Edges
  std::vector<double> areas;    ///< mixed area of each vertex; 0 without faces that have an area
  std::vector<char> is_border;  ///< per vertex: it has an edge of one face
};

CotangentLaplacian cotangent_laplacian(const Mesh& mesh);

}  // namespace transformesh
