// Computes coordinates of a point from its definition: in double-double, in exact numbers, and as
// homogeneous coordinates in balls (numbers with an error bound).
#include "geometry/numbers/exact_coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "geometry/numbers/point_fraction.h"

namespace transformesh {
namespace {

ExactCoordinates exact_coordinates(const PointFraction<ExactNumber>& fraction) {
  const bool negative = sign_of(fraction.denominator) < 0;
  ExactCoordinates result;
  result.w = negative ? -fraction.denominator : fraction.denominator;
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactNumber numerator = negative ? -fraction.numerator[i] : fraction.numerator[i];
    result.x[i] = ExactNumber(fraction.origin[static_cast<int>(i)]) * result.w + numerator;
  }
  return result;
}

NumberVector<DoubleDoubleBall> precise_coordinates(
    const PointFraction<DoubleDoubleBall>& fraction) {
  NumberVector<DoubleDoubleBall> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = fraction.denominator.sign() == 0
                    ? DoubleDoubleBall::unknown()
                    : DoubleDoubleBall(fraction.origin[static_cast<int>(i)]) +
                          fraction.numerator[i] / fraction.denominator;
  }
  return result;
}

template <class Ball>
HomogeneousPoint<Ball> with_positive_weight(HomogeneousPoint<Ball> point) {
  const int sign = point.w.sign();
  if (sign == 0) point.w = Ball::unknown();
  if (sign >= 0) return point;
  for (Ball& x : point.x) x = -x;
  point.w = -point.w;
  return point;
}

template <class Ball>
HomogeneousPoint<Ball> homogeneous_balls(const PointDefinition& definition,
                                         std::span<const Vec3> positions,
                                         std::span<const Face> faces) {
  const auto& d = definition.indices;
  const auto plane = [&](int i) {
    return homogeneous_plane<Ball>(triangle_of(positions, faces[d[i]]));
  };
  switch (definition.kind) {
    case ExactPoint::Kind::line_plane:
      return with_positive_weight(homogeneous_point(positions[d[0]], positions[d[1]], plane(2)));
    case ExactPoint::Kind::three_planes:
      return with_positive_weight(homogeneous_point(plane(0), plane(1), plane(2)));
    default:
      return {{Ball::unknown(), Ball::unknown(), Ball::unknown()}, Ball::unknown()};
  }
}

template <class Visit>
void visit_vertices(const PointDefinition& definition, std::span<const Face> faces,
                    const Visit& visit) {
  const auto& d = definition.indices;
  const auto visit_face = [&](Index face) {
    for (const Index vertex : faces[face]) visit(vertex);
  };
  switch (definition.kind) {
    case ExactPoint::Kind::line_plane:
      visit(d[0]);
      visit(d[1]);
      return visit_face(d[2]);
    case ExactPoint::Kind::line_line:
      for (const Index vertex : d) visit(vertex);
      return;
    case ExactPoint::Kind::three_planes:
      for (std::size_t i = 0; i < 3; ++i) visit_face(d[i]);
      return;
    default:
      return;
  }
}

// True if the magnitudes of coordinates differ so strongly that exact numbers become long.
bool is_spread(const PointDefinition& definition, std::span<const Vec3> positions,
               std::span<const Face> faces) {
  // Ratio of magnitudes above which balls (numbers with an error bound) are tried before exact
  // numbers. A choice that affects time only.
  constexpr double most_spread = 0x1p128;
  double least = std::numeric_limits<double>::max(), most = 0;
  visit_vertices(definition, faces, [&](Index vertex) {
    for (const double x : positions[vertex]) {
      least = x == 0 ? least : std::min(least, std::abs(x));
      most = std::max(most, std::abs(x));
    }
  });
  return most / most_spread > least;
}

}  // namespace

const ExactCoordinates& ExactGeometry::exact(const ExactPoint& point) const {
  if (point.exact) return *point.exact;
  const Vec3& p = point.center;
  ExactCoordinates coordinates =
      is_exact(point)
          ? ExactCoordinates{{{ExactNumber(p[0]), ExactNumber(p[1]), ExactNumber(p[2])},
                              ExactNumber(1)}}
          : exact_coordinates(fraction_of<ExactNumber>(point.definition, positions_, faces_));
  point.exact = std::make_shared<const ExactCoordinates>(std::move(coordinates));
  return *point.exact;
}

const PreciseCoordinates& ExactGeometry::precise(const ExactPoint& point) const {
  if (point.precise) return *point.precise;
  const Vec3& p = point.center;
  PreciseCoordinates coordinates;
  if (is_exact(point)) {
    coordinates.x = {DoubleDoubleBall(p[0]), DoubleDoubleBall(p[1]), DoubleDoubleBall(p[2])};
  } else if (!point.definition.is_known()) {
    coordinates.x.fill(DoubleDoubleBall::unknown());
  } else {
    coordinates.x =
        precise_coordinates(fraction_of<DoubleDoubleBall>(point.definition, positions_, faces_));
    for (int i = 0; i < 3; ++i)
      if (point.radius[i] == 0) coordinates.x[static_cast<std::size_t>(i)] = DoubleDoubleBall(p[i]);
    coordinates.is_spread = is_spread(point.definition, positions_, faces_);
  }
  point.precise = std::make_shared<const PreciseCoordinates>(std::move(coordinates));
  return *point.precise;
}

template <class Ball, class Coordinates>
auto& balls_of(Coordinates& known) {
  if constexpr (std::is_same_v<Ball, WideExponentBall>)
    return known.wide;
  else
    return known.longer;
}

// Stores coordinates in the point's cache. Creates a new cache instead of changing the shared one,
// because other threads may read it through copies of the point.
template <class Ball>
const HomogeneousPoint<Ball>& ExactGeometry::spread(const ExactPoint& point) const {
  if (const auto& balls = balls_of<Ball>(precise(point))) return *balls;
  PreciseCoordinates known = *point.precise;
  auto& balls = balls_of<Ball>(known);
  balls = std::make_shared<const HomogeneousPoint<Ball>>(
      is_exact(point) ? HomogeneousPoint<Ball>{number_vector<Ball>(point.center), Ball(1)}
                      : homogeneous_balls<Ball>(point.definition, positions_, faces_));
  const HomogeneousPoint<Ball>& result = *balls;
  point.precise = std::make_shared<const PreciseCoordinates>(std::move(known));
  return result;
}

template const HomogeneousPoint<WideExponentBall>& ExactGeometry::spread(const ExactPoint&) const;
template const HomogeneousPoint<MultiprecisionBall>& ExactGeometry::spread(const ExactPoint&) const;

}  // namespace transformesh
