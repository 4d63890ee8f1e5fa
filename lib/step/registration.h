/// Iterative closest points: pairs samples of a mesh with a surface, and moves them onto it.
/// References: Chen & Medioni, "Object modelling by registration of multiple range images", Image
/// and Vision Computing 10(3), 1992. Phillips, Liu & Tomasi, "Outlier robust ICP for minimizing
/// fractional RMSD", 3DIM 2007. Beaton & Tukey, "The fitting of power series", Technometrics 16(2),
/// 1974 (the biweight).
#pragma once

#include <functional>
#include <vector>

#include "step/registration_surface.h"
#include "step/rigid_motion.h"

namespace transformesh {

/// Pairs that count as the part that both surfaces show.
struct Overlap {
  std::size_t count = 0;   ///< number of pairs
  double mean_square = 0;  ///< mean squared distance of these pairs
  double cost = 0;         ///< fractional mean square: less is a better agreement
};

/// Chooses the number of the least distances with the least fractional mean square. `distances`
/// are squared and in ascending order; there are `samples` of them with those that have no partner.
Overlap overlap_of(const std::vector<double>& squared_distances, std::size_t samples);

/// Movement that counts as rest, in units of the coordinates, which are about 1.
inline constexpr double registration_rest = 1e-9;

class Registration {
 public:
  /// Keeps a reference to the surface. Coordinates are about 1.
  Registration(const RegistrationSurface& surface, std::vector<OrientedPoint> samples,
               const RigidMotion& start)
      : surface_(surface), samples_(std::move(samples)), motion_(start) {}

  /// Iterates until the pairs are at rest, at most so often. Calls `report` before each iteration.
  /// Returns the number of iterations. Throws GoalError if too few samples find a partner.
  int run(int most, const std::function<void(int)>& report);

  const RigidMotion& motion() const { return motion_; }
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
  double mean_square_ = 0;  ///< mean squared distance of the overlap, last iteration
  double stability_ = 0;
  bool has_converged_ = false;
};

}  // namespace transformesh
