#include "geometry/numbers/predicates.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/random.h"
#include "helpers/rational.h"
#include "helpers/shapes.h"

// The oracle is integer arithmetic. Points on small lattices are often coplanar, collinear or
// equal, and a shift or a scaling by a power of two does not change signs.
using namespace transformesh;

namespace {

using Lattice = std::array<long, 3>;

Lattice random_lattice(test::Random& random, long size) {
  Lattice p;
  for (long& x : p) x = static_cast<long>(random.uniform(0, static_cast<double>(size)));
  return p;
}

Vec3 place(const Lattice& p, double shift, double scale) {
  return Vec3(static_cast<double>(p[0]) + shift, static_cast<double>(p[1]) + shift,
              static_cast<double>(p[2]) + shift) *
         scale;
}

long determinant(const Lattice& a, const Lattice& b, const Lattice& c, const Lattice& d) {
  const auto along = [&](const Lattice& p, int i) {
    return p[static_cast<std::size_t>(i)] - a[static_cast<std::size_t>(i)];
  };
  return along(b, 0) * (along(c, 1) * along(d, 2) - along(c, 2) * along(d, 1)) -
         along(b, 1) * (along(c, 0) * along(d, 2) - along(c, 2) * along(d, 0)) +
         along(b, 2) * (along(c, 0) * along(d, 1) - along(c, 1) * along(d, 0));
}

int sign(long x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

}  // namespace

TEST_CASE("orient3d has the sign of the integer determinant, far out, tiny and huge") {
  test::Random random(1);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const Lattice a = random_lattice(random, 5), b = random_lattice(random, 5),
                  c = random_lattice(random, 5), d = random_lattice(random, 5);
    const int expected = sign(determinant(a, b, c, d));
    zeros += expected == 0 ? 1 : 0;
    for (const auto& [shift, scale] : {std::pair{0.0, 1.0},
                                       {1e9, 1.0},
                                       {0.0, std::ldexp(1.0, -700)},
                                       {0.0, std::ldexp(1.0, 700)},
                                       {3e7, std::ldexp(1.0, -40)}}) {
      const Vec3 pa = place(a, shift, scale), pb = place(b, shift, scale);
      const Vec3 pc = place(c, shift, scale), pd = place(d, shift, scale);
      REQUIRE(orient3d(pa, pb, pc, pd) == expected);
      REQUIRE(OrientedPlane(pa, pb, pc).side_of(pd) == expected);
    }
  }
  CHECK(zeros > 1000);
}

TEST_CASE("signs agree with rationals for coordinates of very different magnitudes") {
  test::Random random(11);
  const auto number = [&] {
    const int exponent = static_cast<int>(random.below(1000)) - 500;
    return std::ldexp(static_cast<double>(random.below(7)) - 3, exponent);
  };
  const auto point = [&] {
    const double x = number(), y = number();
    return Vec3(x, y, number());
  };
  int signs = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::array<Vec3, 4> p = {point(), point(), point(), i % 5 == 0 ? Vec3::Zero() : point()};
    const test::RationalTriangle t = {test::exact(p[0]), test::exact(p[1]), test::exact(p[2])};
    const test::RationalPoint n = test::normal(t);
    const test::Rational volume = test::dot(n, test::minus(test::exact(p[3]), t[0]));
    CHECK(orient3d(p[0], p[1], p[2], p[3]) == volume.sign());
    CHECK(OrientedPlane(p[0], p[1], p[2]).side_of(p[3]) == volume.sign());
    CHECK(orient2d(p[0], p[1], p[2], {0, 1}) == n[2].sign());
    signs += volume != 0 ? 1 : 0;
  }
  CHECK(signs > 2000);
}

TEST_CASE("orient2d and collinear agree with integers") {
  test::Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const Lattice a = random_lattice(random, 4), b = random_lattice(random, 4),
                  c = random_lattice(random, 4);
    const auto turn = [&](std::size_t u, std::size_t v) {
      return sign((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]));
    };
    const Vec3 p = place(a, 1e8, 1), q = place(b, 1e8, 1), r = place(c, 1e8, 1);
    REQUIRE(orient2d(p, q, r, {0, 1}) == turn(0, 1));
    REQUIRE(orient2d(p, q, r, {2, 1}) == turn(2, 1));
    REQUIRE(collinear(p, q, r) == (turn(0, 1) == 0 && turn(1, 2) == 0 && turn(2, 0) == 0));
  }
}

TEST_CASE("a projection shows the triangle turning counter-clockwise") {
  test::Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const Triangle t{place(random_lattice(random, 4), 1e8, 1),
                     place(random_lattice(random, 4), 1e8, 1),
                     place(random_lattice(random, 4), 1e8, 1)};
    if (collinear(t[0], t[1], t[2])) continue;
    REQUIRE(orient2d(t[0], t[1], t[2], projection_of(t)) == 1);
  }
}

TEST_CASE("signs of dot and cross products of normals agree with integers") {
  test::Random random(4);
  const auto normal = [](const std::array<Lattice, 3>& t) {
    Lattice u, v;
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = t[1][i] - t[0][i];
      v[i] = t[2][i] - t[0][i];
    }
    return Lattice{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  for (int i = 0; i < 5000; ++i) {
    std::array<Lattice, 3> s, t;
    for (Lattice& p : s) p = random_lattice(random, 4);
    for (Lattice& p : t) p = random_lattice(random, 4);
    const Lattice n = normal(s), m = normal(t);
    const Triangle ds{place(s[0], 1e8, 1), place(s[1], 1e8, 1), place(s[2], 1e8, 1)};
    const Triangle dt{place(t[0], 1e8, 1), place(t[1], 1e8, 1), place(t[2], 1e8, 1)};
    REQUIRE(normals_dot(ds, dt) == sign(n[0] * m[0] + n[1] * m[1] + n[2] * m[2]));
    REQUIRE(normals_cross(ds, dt, 0) == sign(n[1] * m[2] - n[2] * m[1]));
    REQUIRE(normals_cross(ds, dt, 2) == sign(n[0] * m[1] - n[1] * m[0]));
  }
}

TEST_CASE("faces without area are found exactly") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {3, 3, 3}, {3, 3, 3 + 0x1p-51}};
  mesh.faces = {{0, 1, 2}, {0, 1, 4}, {0, 2, 3}, {0, 2, 4}, {1, 1, 4}, {2, 3, 3}};
  CHECK(degenerate_faces(mesh) == std::vector<Index>{0, 2, 4, 5});

  // Areas far below the smallest double are not zero.
  mesh.positions = {{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}};
  mesh.faces = {{0, 1, 2}};
  CHECK(degenerate_faces(mesh).empty());
  CHECK(degenerate_faces(test::icosphere(3)).empty());
  CHECK(degenerate_faces(Mesh{}).empty());
}
