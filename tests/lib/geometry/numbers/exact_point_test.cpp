#include "geometry/numbers/exact_point.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "helpers/random.h"

// The oracle solves for the points in rationals, by formulas of its own.
namespace transformesh {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;

RationalPoint exact(const Vec3& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Plane {
  RationalPoint normal;
  Rational offset;
};

Plane plane_of(const std::vector<Vec3>& p, const Face& f) {
  const RationalPoint a = exact(p[f[0]]);
  const RationalPoint n = cross(minus(exact(p[f[1]]), a), minus(exact(p[f[2]]), a));
  return {n, dot(n, a)};
}

RationalPoint solve_line_plane(const Vec3& u, const Vec3& v, const Plane& plane) {
  const RationalPoint a = exact(u), step = minus(exact(v), a);
  const Rational t = (plane.offset - dot(plane.normal, a)) / dot(plane.normal, step);
  return {a[0] + t * step[0], a[1] + t * step[1], a[2] + t * step[2]};
}

// Solves the three plane equations by Gaussian elimination.
RationalPoint solve_planes(const std::array<Plane, 3>& planes) {
  std::array<std::array<Rational, 4>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    rows[i] = {planes[i].normal[0], planes[i].normal[1], planes[i].normal[2], planes[i].offset};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    while (rows[pivot][k] == 0) ++pivot;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == k) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = 0; j < 4; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  return {rows[0][3] / rows[0][0], rows[1][3] / rows[1][1], rows[2][3] / rows[2][2]};
}

int sign(const Rational& x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

// Three faces through a common region and lines through them, on a lattice, so that points often
// coincide or are collinear. Coordinates may be far from the origin, where doubles are coarse.
struct Scene {
  std::vector<Vec3> positions;
  std::vector<Face> faces;
  std::vector<ExactPoint> points;
  std::vector<RationalPoint> truth;
};

Vec3 lattice_point(test::Random& random, double shift) {
  const auto coordinate = [&] { return std::floor(random.uniform(0, 5)) + shift; };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

Scene random_scene(std::uint64_t seed, double shift) {
  test::Random random(seed);
  Scene scene;
  while (scene.faces.size() < 6) {
    const auto base = static_cast<Index>(scene.positions.size());
    std::array<Vec3, 3> t;
    for (Vec3& p : t) p = lattice_point(random, shift);
    if (collinear(t[0], t[1], t[2])) continue;
    scene.positions.insert(scene.positions.end(), t.begin(), t.end());
    scene.faces.push_back({base, base + 1, base + 2});
  }
  return scene;
}

bool is_inside(const Scene& scene, Index face, const RationalPoint& p) {
  const Face& f = scene.faces[face];
  const Plane plane = plane_of(scene.positions, f);
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint a = exact(scene.positions[f[i]]);
    const RationalPoint b = exact(scene.positions[f[(i + 1) % 3]]);
    if (dot(plane.normal, cross(minus(b, a), minus(p, a))) < 0) return false;
  }
  return true;
}

void add_points(Scene& scene) {
  const ExactGeometry geometry(scene.positions, scene.faces);
  for (Index v = 0; v < scene.positions.size(); ++v) {
    scene.points.push_back(geometry.given(v));
    scene.truth.push_back(exact(scene.positions[v]));
  }
  for (Index f = 0; f < scene.faces.size(); ++f) {
    const Triangle t{scene.positions[scene.faces[f][0]], scene.positions[scene.faces[f][1]],
                     scene.positions[scene.faces[f][2]]};
    for (Index v = 0; v < scene.positions.size(); v += 2) {
      const Index w = (v + 5) % static_cast<Index>(scene.positions.size());
      if (orient3d(t[0], t[1], t[2], scene.positions[v]) *
              orient3d(t[0], t[1], t[2], scene.positions[w]) >=
          0) {
        continue;
      }
      scene.points.push_back(geometry.point(PointDefinition::line_plane(v, w, f)));
      scene.truth.push_back(solve_line_plane(scene.positions[v], scene.positions[w],
                                             plane_of(scene.positions, scene.faces[f])));
    }
  }
  for (Index f = 0; f < 6; ++f) {
    for (Index g = f + 1; g < 6; ++g) {
      for (Index h = g + 1; h < 6; ++h) {
        const std::array<Plane, 3> planes{plane_of(scene.positions, scene.faces[f]),
                                          plane_of(scene.positions, scene.faces[g]),
                                          plane_of(scene.positions, scene.faces[h])};
        if (dot(planes[0].normal, cross(planes[1].normal, planes[2].normal)) == 0) continue;
        const RationalPoint p = solve_planes(planes);
        if (!is_inside(scene, f, p) || !is_inside(scene, g, p) || !is_inside(scene, h, p)) continue;
        scene.points.push_back(geometry.three_planes(h, f, g));
        scene.truth.push_back(p);
      }
    }
  }
}

}  // namespace

TEST_CASE("orientation and order of defined points agree with rationals") {
  test::Random random(7);
  int defined = 0;
  int equal = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    Scene scene = random_scene(seed, seed % 3 == 0 ? 1e7 : 0.1);
    // Scales the coordinates so that their products leave the range of doubles.
    if (seed > 60)
      for (Vec3& p : scene.positions) p = Vec3(1e-140, 1e130, 1e145).cwiseProduct(p);
    add_points(scene);
    const ExactGeometry geometry(scene.positions, scene.faces);
    std::vector<ExactPlane> planes;
    for (Index f = 0; f < 6; ++f) planes.push_back(geometry.plane(f));
    defined += static_cast<int>(scene.points.size() - scene.positions.size());
    const auto pick = [&] {
      return static_cast<std::size_t>(random.uniform(0, static_cast<double>(scene.points.size())));
    };
    for (int i = 0; i < 200; ++i) {
      const std::size_t a = pick(), b = pick(), c = pick();
      const RationalPoint &p = scene.truth[a], &q = scene.truth[b], &r = scene.truth[c];
      const int turn = sign((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
      REQUIRE(geometry.orient2d(scene.points[a], scene.points[b], scene.points[c], {0, 1}) == turn);
      const int order = p < q ? -1 : (q < p ? 1 : 0);
      equal += order == 0 && a != b ? 1 : 0;
      REQUIRE(geometry.compare(scene.points[a], scene.points[b]) == order);
      const Face& f = scene.faces[c % 6];
      const Plane plane = plane_of(scene.positions, f);
      const Triangle t{scene.positions[f[0]], scene.positions[f[1]], scene.positions[f[2]]};
      const int side = sign(dot(plane.normal, p) - plane.offset);
      REQUIRE(geometry.orient3d(t, scene.points[a]) == side);
      REQUIRE(geometry.orient3d(planes[c % 6], scene.points[a]) == side);
      for (int k = 0; k < 3; ++k) {
        const Rational off = p[static_cast<std::size_t>(k)] - Rational(scene.points[a].center[k]);
        REQUIRE(abs(off) <= Rational(scene.points[a].radius[k]));
      }
    }
  }
  CHECK(defined > 300);
  CHECK(equal > 20);
}

TEST_CASE("intersections of edges and weighted means agree with rationals") {
  const std::vector<Vec3> positions{{0, 0, 0}, {3, 1, 2}, {0, 1, 2}, {3, 0, 0}, {1e6, 1, 7}};
  const std::vector<Face> faces{{0, 1, 2}};
  const ExactGeometry geometry(positions, faces);
  const ExactPoint crossing = geometry.point(PointDefinition::line_line(0, 1, 2, 3));
  const ExactPoint middle = ExactGeometry::free({1.5, 0.5, 1});
  CHECK(geometry.compare(crossing, middle) == 0);
  CHECK(geometry.compare(geometry.point(PointDefinition::line_line(3, 2, 1, 0)), middle) == 0);

  // The point (2 a + 3 b + 5 c) / 10 of given points and of an intersection point.
  const ExactPoint mean = geometry.mean(geometry.given(4), crossing, geometry.given(3), {2, 3, 5});
  const RationalPoint truth{(2 * Rational(1e6) + 3 * Rational(1.5) + 5 * 3) / 10,
                            (2 + Rational(1.5)) / 10, Rational(14 + 3) / 10};
  for (int k = 0; k < 3; ++k) {
    CHECK(abs(truth[static_cast<std::size_t>(k)] - Rational(mean.center[k])) <=
          Rational(mean.radius[k]));
  }
  CHECK(geometry.compare_coordinate(mean, ExactGeometry::free({0, 0.35, 0}), 1) ==
        sign(Rational(35) / 100 - Rational(0.35)));
}

TEST_CASE("only a definition makes points the same: means and free points have none") {
  const std::vector<Vec3> positions{{0, 0, 0}, {3, 1, 2}, {0, 1, 2}, {3, 0, 0}, {1, 5, 7}};
  const std::vector<Face> faces{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}};
  const ExactGeometry geometry(positions, faces);
  const ExactPoint a = geometry.given(0), b = geometry.given(1), c = geometry.given(2);
  CHECK(same_definition(geometry.point(PointDefinition::line_line(0, 1, 2, 3)),
                        geometry.point(PointDefinition::line_line(3, 2, 1, 0))));
  CHECK(same_definition(geometry.three_planes(0, 1, 2), geometry.three_planes(2, 0, 1)));
  CHECK(!same_definition(a, b));
  CHECK(same_definition(a, geometry.given(0)));

  const ExactPoint first = geometry.mean(a, b, c, {1, 2, 3});
  const ExactPoint second = geometry.mean(a, b, c, {3, 2, 1});
  CHECK(first.definition.kind == ExactPoint::Kind::mean);
  CHECK(geometry.compare(first, second) != 0);
  CHECK(!same_definition(first, second));
  CHECK(!same_definition(first, geometry.three_planes(0, 1, 2)));
  CHECK(!same_definition(ExactGeometry::free({1, 1, 1}), a));
  CHECK(!same_definition(ExactGeometry::free({1, 1, 1}), ExactGeometry::free({2, 2, 2})));
}

}  // namespace transformesh
