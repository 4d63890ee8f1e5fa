#include "geometry/numbers/exact_point.h"

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "geometry/numbers/exact_coordinates.h"
#include "geometry/numbers/machine_epsilon.h"
#include "geometry/numbers/point_fraction.h"

namespace transformesh {
namespace {

using Interval = CGAL::Interval_nt<false>;

// Sets coordinate `i` of the ball that contains the point: the center of the interval [low, high],
// and a radius that includes the rounding errors.
void set_ball(ExactPoint& point, int i, double low, double high) {
  if (!(std::isfinite(low) && std::isfinite(high) && low <= high)) {
    point.center[i] = 0;
    point.radius[i] = std::numeric_limits<double>::infinity();
    return;
  }
  const double center = low + (high - low) / 2;
  const double radius = std::max(high - center, center - low);
  point.center[i] = center;
  point.radius[i] = radius == 0 ? 0 : radius * (1 + 4 * machine_epsilon) + 1e-300;
}

bool has_sign(const Interval& number) { return !number.do_overlap(Interval(0)); }
bool has_sign(const WideExponentBall& number) { return number.sign() != 0; }
std::array<double, 2> ends_of(const Interval& number) { return {number.inf(), number.sup()}; }
std::array<double, 2> ends_of(const WideExponentBall& number) {
  return {number.low(), number.high()};
}

// Sets the ball that contains the point from the point's coordinates as fractions. Restricts the
// ball to the box that is known to contain the point. Returns true if the fraction gives finite
// bounds.
template <class Number>
bool set_balls(ExactPoint& point, const PointFraction<Number>& fraction, const Vec3& low,
               const Vec3& high) {
  const bool is_certain = has_sign(fraction.denominator);
  bool is_finite = is_certain;
  for (int i = 0; i < 3; ++i) {
    double from = low[i];
    double to = high[i];
    if (is_certain) {
      const auto [least, most] =
          ends_of(Number(fraction.origin[i]) +
                  fraction.numerator[static_cast<std::size_t>(i)] / fraction.denominator);
      is_finite = is_finite && std::isfinite(least) && std::isfinite(most);
      from = std::max(from, least);
      to = std::min(to, most);
    }
    set_ball(point, i, from, to);
  }
  return is_finite;
}

// If coordinates are smaller than this, products of seven of their differences do not overflow.
constexpr double large = 0x1p140;

// Sets the ball that contains the point by interval arithmetic. If intervals may overflow, uses
// WideExponentBall instead, because the result of an overflow depends on the processor.
// `fraction_in` computes the coordinates as fractions in the number type of its argument. `size` is
// the largest absolute value of the coordinates.
template <class FractionIn>
void set_balls(ExactPoint& point, const FractionIn& fraction_in, double size, const Vec3& low,
               const Vec3& high) {
  const CGAL::Protect_FPU_rounding<true> upward;
  if (size < large && set_balls(point, fraction_in(Interval(0)), low, high)) return;
  set_balls(point, fraction_in(WideExponentBall(0)), low, high);
}

double size_of(std::initializer_list<Vec3> points) {
  double size = 0;
  for (const Vec3& p : points) size = std::max(size, p.cwiseAbs().maxCoeff());
  return size;
}
double size_of(const Triangle& t) { return size_of({t[0], t[1], t[2]}); }

}  // namespace

Triangle ExactGeometry::triangle(Index face) const { return triangle_of(positions_, faces_[face]); }

ExactPoint ExactGeometry::point(const PointDefinition& definition) const {
  switch (definition.kind) {
    case ExactPoint::Kind::given: {
      ExactPoint point = free(positions_[definition.indices[0]]);
      point.definition = definition;
      return point;
    }
    case ExactPoint::Kind::line_plane:
      return line_plane(definition);
    case ExactPoint::Kind::line_line:
      return line_line(definition);
    default:
      throw std::logic_error("a definition does not make a point");
  }
}

ExactPoint ExactGeometry::free(const Vec3& position) {
  ExactPoint point;
  point.center = position;
  return point;
}

ExactPoint ExactGeometry::line_plane(const PointDefinition& definition) const {
  const auto [u, v, face, none] = definition.indices;
  const Vec3 &a = positions_[u], &b = positions_[v];
  const Triangle plane = triangle(face);
  ExactPoint point;
  point.definition = definition;
  const auto fraction = [&]<class Number>(const Number&) {
    return line_plane_fraction<Number>(a, b, plane);
  };
  set_balls(point, fraction, std::max(size_of({a, b}), size_of(plane)), a.cwiseMin(b),
            a.cwiseMax(b));
  return point;
}

ExactPoint ExactGeometry::line_line(const PointDefinition& definition) const {
  const auto& ends = definition.indices;
  const Vec3 &a = positions_[ends[0]], &b = positions_[ends[1]];
  const Vec3 &c = positions_[ends[2]], &d = positions_[ends[3]];
  ExactPoint point;
  point.definition = definition;
  const PlaneProjection projection = projection_of_edges(a, b, c, d);
  const auto fraction = [&]<class Number>(const Number&) {
    return line_line_fraction<Number>(a, b, c, d, projection);
  };
  set_balls(point, fraction, size_of({a, b, c, d}), a.cwiseMin(b).cwiseMax(c.cwiseMin(d)),
            a.cwiseMax(b).cwiseMin(c.cwiseMax(d)));
  return point;
}

ExactPoint ExactGeometry::three_planes(Index f, Index g, Index h) const {
  ExactPoint point;
  point.definition = PointDefinition::three_planes(f, g, h);
  const auto& ids = point.definition.indices;
  std::array<Triangle, 3> planes{triangle(ids[0]), triangle(ids[1]), triangle(ids[2])};
  Vec3 low = Vec3::Constant(-std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (const Triangle& t : {triangle(g), triangle(h)}) {
    low = low.cwiseMax(t[0].cwiseMin(t[1]).cwiseMin(t[2]));
    high = high.cwiseMin(t[0].cwiseMax(t[1]).cwiseMax(t[2]));
  }
  const auto fraction = [&]<class Number>(const Number&) {
    return three_planes_fraction<Number>(planes[0], planes[1], planes[2]);
  };
  const double size = std::max({size_of(planes[0]), size_of(planes[1]), size_of(planes[2])});
  set_balls(point, fraction, size, low, high);
  return point;
}

std::array<Index, 10> ExactGeometry::vertices_of(const PointDefinition& definition) const {
  using Kind = PointDefinition::Kind;
  const auto sorted = [&](Index face) {
    Face corners = faces_[face];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  const std::array<Index, 4>& of = definition.indices;
  std::array<Index, 10> vertices = {static_cast<Index>(definition.kind), of[0], of[1], of[2],
                                    of[3]};
  if (definition.kind == Kind::line_plane) {
    const Face face = sorted(of[2]);
    std::copy(face.begin(), face.end(), vertices.begin() + 3);
  } else if (definition.kind == Kind::three_planes) {
    std::array<Face, 3> faces = {sorted(of[0]), sorted(of[1]), sorted(of[2])};
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 0; i < 9; ++i) vertices[1 + i] = faces[i / 3][i % 3];
  }
  return vertices;
}

Vec3 ExactGeometry::position(const ExactPoint& point) const {
  if ((point.radius.array() <= machine_epsilon / 2 * point.center.array().abs()).all())
    return point.center;
  if (!point.exact) {
    const auto& x = precise(point).x;
    const std::array known = {x[0].truncated(), x[1].truncated(), x[2].truncated()};
    if (known[0] && known[1] && known[2]) return {*known[0], *known[1], *known[2]};
  }
  const ExactCoordinates& e = exact(point);
  return {quotient(e.x[0], e.w), quotient(e.x[1], e.w), quotient(e.x[2], e.w)};
}

ExactPoint ExactGeometry::mean(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                               const std::array<int, 3>& weights) const {
  const std::array<const ExactPoint*, 3> points{&a, &b, &c};
  const int total = weights[0] + weights[1] + weights[2];
  ExactPoint result;
  result.definition.kind = ExactPoint::Kind::mean;

  for (std::size_t k = 0; k < 3; ++k) {
    const double share = static_cast<double>(weights[k]) / total;
    result.center += share * points[k]->center;
    result.radius += share * points[k]->radius;
    result.radius += 8 * machine_epsilon * points[k]->center.cwiseAbs();
  }
  result.radius = result.radius * (1 + 16 * machine_epsilon) + Vec3::Constant(1e-300);

  // Compute the exact coordinates over the common denominator of all weights.
  const ExactCoordinates &ea = exact(a), &eb = exact(b), &ec = exact(c);
  const std::array<const ExactCoordinates*, 3> e{&ea, &eb, &ec};
  const std::array<ExactNumber, 3> others{eb.w * ec.w, ea.w * ec.w, ea.w * eb.w};
  ExactCoordinates coordinates;
  coordinates.w = ea.w * others[0] * ExactNumber(total);
  for (std::size_t i = 0; i < 3; ++i) {
    coordinates.x[i] = ExactNumber(0);
    for (std::size_t k = 0; k < 3; ++k) {
      coordinates.x[i] = coordinates.x[i] + e[k]->x[i] * others[k] * ExactNumber(weights[k]);
    }
  }
  result.exact = std::make_shared<const ExactCoordinates>(std::move(coordinates));
  return result;
}

}  // namespace transformesh
