/// The Laplace-Beltrami operator of a mesh by cotangents over mixed areas. O(n); deterministic.
/// Reference: Meyer, Desbrun, Schroeder & Barr, "Discrete differential-geometry operators for
/// triangulated 2-manifolds", Visualization and Mathematics III, 2003.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// How the cotangents of thin triangles are bounded.
enum class CotangentBounds {
  /// Each angle is clamped to 5 to 175 degrees, and each edge weight to at least 0. No vertex is
  /// then pushed away from a neighbor. Edges opposite obtuse angles get wrong weights.
  each_edge,
  /// The cotangents of a triangle with an angle below 1 degree are scaled down together. Other
  /// cotangents are exact. The operator stays negative semidefinite, so that implicit steps are
  /// stable.
  each_triangle
};

/// The Laplacian of a function f at vertex v is the sum over the edges of v of weight *
/// (f(neighbor) - f(v)), divided by 2 * areas[v].
struct CotangentLaplacian {
  struct WeightedEdge {
    Index from = 0;
    Index to = 0;
    double weight = 0;  ///< sum of the cotangents opposite of the edge
  };

  std::vector<WeightedEdge> edges;  ///< edges with weights, in the order of Edges
  /// Mixed area of each vertex; 0 if no face at the vertex has an area.
  std::vector<double> areas;
  std::vector<char> is_border;  ///< 1 for each vertex at an edge of only one face
};

CotangentLaplacian cotangent_laplacian(const Mesh& mesh, CotangentBounds bounds);

}  // namespace transformesh
