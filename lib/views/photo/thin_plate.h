/// Computes Newton steps of a surface that resists bending.
///
/// The energy has two terms. The data term is the sum of g d + h d^2 / 2 over all vertices, where d
/// is the movement along the normal. The plate term is stiffness / 2 |L x|^2. L is the uniform
/// Laplacian: L x is the vector from a vertex to the mean of its neighbors.
/// Reference: the umbrella operator of Kobbelt, Campagna, Vorsatz & Seidel, "Interactive
/// multi-resolution modeling on arbitrary meshes", SIGGRAPH 1998.
///
/// Vertices with large h move to the minimum of the data term; vertices with small h continue the
/// surface around them smoothly. The plate term omits border vertices.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Neighbors of every vertex along edges, and the uniform Laplacian over them.
class UniformLaplacian {
 public:
  explicit UniformLaplacian(const Mesh& mesh);

  /// Sets `result` to the vectors from the value of each vertex to the mean of its neighbors'
  /// values; 0 at vertices without neighbors.
  void apply(std::span<const Vec3> values, std::vector<Vec3>& result) const;
  /// Sets `result` to L^T L `values`, where rows of L that belong to border vertices are zero.
  void apply_bending(std::span<const Vec3> values, std::vector<Vec3>& result) const;
  bool is_border(Index vertex) const { return share_[vertex] == 0 && !neighbors(vertex).empty(); }
  std::span<const Index> neighbors(Index vertex) const {
    return {ids_.data() + offsets_[vertex], ids_.data() + offsets_[vertex + 1]};
  }

 private:
  std::vector<Index> offsets_;
  std::vector<Index> ids_;
  /// For each vertex, 1 / number of neighbors; 0 at border vertices and at vertices without
  /// neighbors.
  std::vector<double> share_;
};

struct ThinPlateProblem {
  std::vector<Vec3> normals;      ///< unit or zero vectors; vertices with zero vectors do not move
  std::vector<double> gradient;   ///< gradient g of the data term
  std::vector<double> curvature;  ///< curvature h of the data term, >= 0
  double stiffness = 0;           ///< weight of the plate term, >= 0
};

/// Returns movements d of the vertices along their normals that decrease the energy. Uses conjugate
/// gradients with a diagonal preconditioner: at most 20 iterations, fewer if the residual falls to
/// 5 %. This precision suffices, because the next step of an evolution continues from the result.
/// If `stiffness` is 0, the result is exactly -g / h. If h is 0 and the plate term does not move a
/// vertex, its d is 0. O(n); deterministic.
std::vector<double> thin_plate_step(const Mesh& mesh, const UniformLaplacian& laplacian,
                                    const ThinPlateProblem& problem);

}  // namespace transformesh
