/// Iterative closest points with point-to-plane distances: pairs samples of a mesh with their
/// closest points on a surface, moves the samples onto the tangent planes, and repeats.
/// References: Chen & Medioni, "Object modelling by registration of multiple range images", Image
/// and Vision Computing 10(3), 1992, for the distances. Phillips, Liu & Tomasi, "Outlier robust ICP
/// for minimizing fractional RMSD", 3DIM 2007, for the overlap. Beaton & Tukey, "The fitting of
/// power series", Technometrics 16(2), 1974, for the weights. Cost: O(n log m) per iteration, for n
/// samples and m faces.
#pragma once

#include <functional>
#include <vector>

#include "step/registration_surface.h"
#include "step/rigid_motion.h"

namespace transformesh {

/// Overlap of two surfaces: the pairs with the smallest distances.
struct Overlap {
  std::size_t count = 0;   ///< number of pairs
  double mean_square = 0;  ///< mean squared distance of these pairs
  double cost = 0;         ///< fractional mean square distance; a lower value is a better agreement
};

/// Chooses the number of pairs, starting with the smallest distance, that minimizes the fractional
/// mean square distance. `squared_distances` are ascending. `samples` is the number of samples,
/// including those without a partner.
Overlap overlap_of(const std::vector<double>& squared_distances, std::size_t samples);

/// A registration has converged if no pair moves farther than this, in a frame in which coordinates
/// are about 1. The limit is larger than rounding errors and smaller than any distance of interest.
inline constexpr double registration_rest = 1e-9;

class Registration {
 public:
  /// Keeps a reference to the surface. Coordinates must be about 1; align() scales them.
  Registration(const RegistrationSurface& surface, std::vector<OrientedPoint> samples,
               const RigidMotion& start)
      : surface_(surface), samples_(std::move(samples)), motion_(start) {}

  /// Iterates until convergence, at most `most` times. Before each iteration, calls `report` with
  /// its number, from 1. Returns the number of iterations. Throws GoalError if too few samples find
  /// a partner.
  int run(int most, const std::function<void(int)>& report);

  const RigidMotion& motion() const { return motion_; }
  /// Returns PlaneEquations::Solution::stability of the last iteration.
  double stability() const { return stability_; }
  bool has_converged() const { return has_converged_; }
  Overlap overlap() const;

 private:
  struct Pair;
  std::vector<Pair> sorted_pairs() const;
  Pair pair_of(const OrientedPoint& sample) const;
  Overlap overlap_of_pairs(const std::vector<Pair>& pairs) const;
  double improve();

  const RegistrationSurface& surface_;
  std::vector<OrientedPoint> samples_;
  RigidMotion motion_;
  double mean_square_ = 0;  ///< mean squared distance of the overlap in the last iteration
  double stability_ = 0;
  bool has_converged_ = false;
};

}  // namespace transformesh
