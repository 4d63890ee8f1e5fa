/// Coordinates of an ExactPoint in exact numbers and in numbers with an error bound. Computed on
/// demand from the definition of the point.
#pragma once

#include <limits>
#include <memory>

#include "geometry/numbers/double_double_ball.h"
#include "geometry/numbers/exact_number.h"
#include "geometry/numbers/exact_point.h"
#include "geometry/numbers/homogeneous.h"
#include "geometry/numbers/multiprecision_ball.h"
#include "geometry/numbers/wide_exponent_ball.h"

namespace transformesh {

/// Exact homogeneous coordinates of a point, with positive weight.
struct ExactCoordinates : HomogeneousPoint<ExactNumber> {};

/// Coordinates with twice the precision of a double, if these can be computed. If magnitudes in the
/// definition differ strongly, numbers become long and digits are lost. Then homogeneous
/// coordinates with positive weight are more precise, stored as balls (numbers with an error
/// bound). Each kind is computed on demand.
struct PreciseCoordinates {
  NumberVector<DoubleDoubleBall> x;
  bool is_spread = false;
  std::shared_ptr<const HomogeneousPoint<WideExponentBall>> wide;
  std::shared_ptr<const HomogeneousPoint<MultiprecisionBall>> longer;
};

struct PreciseNormal {
  NumberVector<DoubleDoubleBall> normal;
};
struct ExactPlaneCoordinates : HomogeneousPlane<ExactNumber> {};

/// True if the ball in doubles that contains the point has radius 0, so that its center is the
/// exact point.
inline bool is_exact(const ExactPoint& point) { return point.radius == Vec3::Zero(); }

}  // namespace transformesh
