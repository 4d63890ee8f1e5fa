/// Newton steps of a surface that resists bending.
///
/// The energy is a sum over vertices, g d + h d^2 / 2 for a movement by d along the normal, plus
/// that of a thin plate, stiffness / 2 |L x|^2, with L x the way from a vertex to the mean of its
/// neighbors (the umbrella of Kobbelt, Campagna, Vorsatz & Seidel, "Interactive multi-resolution
/// modeling on arbitrary meshes", SIGGRAPH 1998). Where h is large the data decide, where it is
/// small the plate goes on smoothly. Borders are free.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// The neighbors of every vertex along edges, and the umbrella over them.
class UniformLaplacian {
 public:
  explicit UniformLaplacian(const Mesh& mesh);

  /// The way to the mean of the neighbors; 0 at vertices without any.
  void apply(std::span<const Vec3> values, std::vector<Vec3>& result) const;
  /// L^T L with L zero at borders.
  void apply_bending(std::span<const Vec3> values, std::vector<Vec3>& result) const;
  std::span<const Index> neighbors(Index vertex) const {
    return {ids_.data() + offsets_[vertex], ids_.data() + offsets_[vertex + 1]};
  }

 private:
  std::vector<Index> offsets_;
  std::vector<Index> ids_;
  std::vector<double> share_;  ///< 1 / number of neighbors, 0 at borders and without neighbors
};

struct ThinPlateProblem {
  std::vector<Vec3> normals;      ///< unit or zero
  std::vector<double> gradient;   ///< g
  std::vector<double> curvature;  ///< h >= 0
  double stiffness = 0;           ///< >= 0
};

/// The d that lower the energy, by conjugate gradients with a diagonal preconditioner: at most 20
/// iterations, fewer where the residual falls to 5 %; what is left is for the next step of an
/// evolution. With stiffness 0 exactly -g / h. Vertices with h = 0 that no plate moves have d = 0.
/// O(n); deterministic.
std::vector<double> thin_plate_step(const Mesh& mesh, const UniformLaplacian& laplacian,
                                    const ThinPlateProblem& problem);

}  // namespace transformesh
