#include "geometry/search/closest_point.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Checks that the point is closest in its triangle: no corner is farther ahead in the direction of
/// the query.
void check_closest(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 point = closest_point_of_triangle(query, a, b, c).point;
  const double size = (b - a).norm() + (c - a).norm() + (query - a).norm();
  for (const Vec3& corner : {a, b, c})
    CHECK((query - point).dot(corner - point) <= 1e-13 * size * size);
  // Checks that the point lies in the triangle: it is in no direction farther than the farthest
  // corner.
  test::Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Vec3 direction = random.point(-1, 1);
    const double reach = std::max({direction.dot(a), direction.dot(b), direction.dot(c)});
    CHECK(direction.dot(point) <= reach + 1e-13 * (size + a.norm()));
  }
}

/// Returns the distance to the box [-1, 1]^3, negative inside.
double cube_distance(const Vec3& query) {
  const Vec3 beyond = query.cwiseAbs() - Vec3::Ones();
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

/// Returns the winding number, 1 inside and 0 outside, by solid angles (Van Oosterom & Strackee
/// 1983).
double winding_number(const Mesh& mesh, const Vec3& query) {
  double sum = 0;
  for (const Face& face : mesh.faces) {
    const Vec3 a = mesh.positions[face[0]] - query;
    const Vec3 b = mesh.positions[face[1]] - query;
    const Vec3 c = mesh.positions[face[2]] - query;
    const double below = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                         b.dot(c) * a.norm() + c.dot(a) * b.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), below);
  }
  return sum / (4 * std::numbers::pi);
}

/// A surface with spikes in and out: many acute edges and corners.
Mesh spiky_sphere() {
  Mesh mesh = test::icosphere(3);
  test::Random random(6);
  for (Vec3& point : mesh.positions) point *= random.uniform(0.4, 1.4);
  return mesh;
}

}  // namespace

TEST_CASE("the closest point of a triangle is optimal, from anywhere") {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a = random.point(-1, 1);
    const Vec3 b = random.point(-1, 1);
    const Vec3 c = random.point(-1, 1);
    check_closest(random.point(-2, 2), a, b, c);
    check_closest(0.2 * a + 0.5 * b + 0.3 * c, a, b, c);
  }
}

TEST_CASE("degenerate triangles have closest points as segments and points do") {
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec3 a = random.point(-1, 1);
    const Vec3 b = random.point(-1, 1);
    const Vec3 query = random.point(-2, 2);
    check_closest(query, a, b, a + random.uniform(-1, 2) * (b - a));
    check_closest(query, a, a, b);
    check_closest(query, a, b, a);
    check_closest(query, a, a, a);
    check_closest(a, a, b, 0.5 * (a + b));
    const Vec3 near_line = a + 0.5 * (b - a) + 1e-15 * random.point(-1, 1);
    check_closest(query, a, b, near_line);
  }
}

TEST_CASE("the part of the triangle is named") {
  const Vec3 a(0, 0, 0);
  const Vec3 b(1, 0, 0);
  const Vec3 c(0, 1, 0);
  const auto part = [&](double x, double y, double z) {
    return closest_point_of_triangle({x, y, z}, a, b, c).part;
  };
  CHECK(part(0.2, 0.2, 3) == TriangleSimplex::inside);
  CHECK(part(-1, -1, 1) == TriangleSimplex::corner_0);
  CHECK(part(5, -1, 1) == TriangleSimplex::corner_1);
  CHECK(part(-1, 5, 0) == TriangleSimplex::corner_2);
  CHECK(part(0.5, -1, 1) == TriangleSimplex::edge_0);
  CHECK(part(1, 1, 0) == TriangleSimplex::edge_1);
  CHECK(part(-1, 0.5, 0) == TriangleSimplex::edge_2);
}

TEST_CASE("signed distances to a cube agree with the closed form") {
  const Mesh mesh = test::cuboid(-Vec3::Ones(), Vec3::Ones());
  const ClosestPointQuery closest(mesh);
  test::Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 query = random.point(-2.5, 2.5);
    CHECK(closest(query).signed_distance == Approx(cube_distance(query)).epsilon(1e-13));
  }
  const ClosestPoint corner = closest(Vec3(2, 3, 4));
  CHECK(corner.point == Vec3(1, 1, 1));
  CHECK((corner.pseudonormal - Vec3::Ones().normalized()).norm() < 1e-15);
  CHECK(closest(Vec3(1, 1, 1)).signed_distance == 0);
}

TEST_CASE("a hint changes no result, and a face within a distance is found if there is one") {
  const Mesh mesh = spiky_sphere();
  const ClosestPointQuery closest(mesh);
  test::Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 query = random.point(-1.5, 1.5);
    const auto hint = static_cast<Index>(random.below(mesh.faces.size()));
    const ClosestPoint found = closest(query);
    const ClosestPoint hinted = closest(query, hint);
    CHECK(hinted.point == found.point);
    CHECK(hinted.face == found.face);
    CHECK(hinted.signed_distance == found.signed_distance);
    for (const Index first : {no_index, hint}) {
      CHECK(closest.face_within(query, 0.999 * found.distance, first) == no_index);
      const Index near = closest.face_within(query, 1.1 * found.distance, first);
      REQUIRE(near != no_index);
      const auto& [a, b, c] = mesh.faces[near];
      const Vec3 point =
          closest_point_of_triangle(query, mesh.positions[a], mesh.positions[b], mesh.positions[c])
              .point;
      CHECK((point - query).norm() <= 1.1 * found.distance);
    }
  }
}

TEST_CASE("the closest point within a distance on faces that pass agrees with a search") {
  const Mesh mesh = spiky_sphere();
  const ClosestPointQuery closest(mesh);
  test::Random random(9);
  int found_some = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 query = random.point(-1.5, 1.5);
    const Vec3 direction = random.point(-1, 1);
    const double distance = random.uniform(0, 1);
    const auto passes = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      return direction.dot((b - a).cross(c - a)) > 0;
    };
    double least = distance;
    for (const auto& [i0, i1, i2] : mesh.faces) {
      const Vec3 &a = mesh.positions[i0], &b = mesh.positions[i1], &c = mesh.positions[i2];
      if (passes(a, b, c))
        least = std::min(least, (closest_point_of_triangle(query, a, b, c).point - query).norm());
    }
    const std::optional<Vec3> found = closest.closest_within(query, distance, passes);
    REQUIRE(found.has_value() == (least < distance));
    if (!found) continue;
    CHECK((*found - query).norm() == Approx(least));
    ++found_some;
  }
  CHECK(found_some > 50);
  CHECK(found_some < 450);
}

TEST_CASE("closest points agree with a search, the sign with the winding number") {
  const Mesh mesh = spiky_sphere();
  const ClosestPointQuery closest(mesh);
  test::Random random(4);
  for (int i = 0; i < 300; ++i) {
    const Vec3 query = random.point(-1.5, 1.5);
    std::pair<double, Index> expected{std::numeric_limits<double>::infinity(), no_index};
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      const Vec3 point =
          closest_point_of_triangle(query, mesh.positions[a], mesh.positions[b], mesh.positions[c])
              .point;
      const Vec3 d = point - query;
      expected = std::min(expected, {d.x() * d.x() + d.y() * d.y() + d.z() * d.z(), f});
    }
    const ClosestPoint found = closest(query);
    CHECK(found.face == expected.second);
    CHECK(found.distance == Approx(std::sqrt(expected.first)).epsilon(1e-14));
    CHECK((found.signed_distance < 0) == (winding_number(mesh, query) > 0.5));
  }
}

TEST_CASE("a nearby point is on the mesh, and farther than the closest by no more than allowed") {
  const Mesh mesh = spiky_sphere();
  const ClosestPointQuery closest(mesh);
  test::Random random(8);
  std::size_t others = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 query = random.point(-4, 4);
    const double least = closest(query).distance;
    for (const double tolerance : {0.0, 0.05, 0.5}) {
      const Vec3 point = closest.nearby(query, tolerance);
      CHECK((point - query).norm() >= least);
      CHECK((point - query).norm() <= (1 + tolerance) * least * (1 + 1e-12));
      CHECK(closest(point).distance <= 1e-14);
      others += (point - query).norm() > least;
    }
  }
  CHECK(others > 0);
}

TEST_CASE("the lowest face wins ties; duplicates and flat faces do not disturb") {
  Mesh mesh = test::cube();
  const std::size_t faces = mesh.faces.size();
  for (std::size_t f = 0; f < faces; ++f) mesh.faces.push_back(mesh.faces[f]);
  const ClosestPointQuery closest(mesh);
  test::Random random(7);
  for (int i = 0; i < 200; ++i) CHECK(closest(random.point(-1, 2)).face < faces);

  Mesh degenerate = test::cube();
  degenerate.faces.push_back({0, 0, 1});
  degenerate.faces.push_back({3, 3, 3});
  const ClosestPointQuery on_degenerate(degenerate);
  const ClosestPointQuery on_cube(mesh);
  for (int i = 0; i < 200; ++i) {
    const Vec3 query = random.point(-1, 2);
    CHECK(on_degenerate(query).distance == on_cube(query).distance);
  }
}

TEST_CASE("a face at a right angle does not face the point, for any rounding") {
  test::Random random(41);
  const Vec3 place(0.25, 0.375, 0);
  for (int trial = 0; trial < 200; ++trial) {
    // Face 0 is perpendicular to face 1; its edge from vertex 3 to 4 lies in face 1 and passes
    // through `place`.
    Mesh mesh{{Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(-1, 2, 0), place - Vec3(0.5, 0.25, 0),
               place + Vec3(0.5, 0.25, 0), place + Vec3(0, 0, 1)},
              {{3, 4, 5}, {0, 1, 2}},
              {},
              {}};
    const Eigen::AngleAxisd turn(random.uniform(0, 6), random.point(-1, 1).normalized());
    for (Vec3& position : mesh.positions) position = turn * position;
    CHECK(ClosestPointQuery(mesh).facing(turn * place, turn * Vec3::UnitZ()).face == 1);
  }
}

TEST_CASE("scale does not matter, down to 1e-30 and up to 1e30") {
  const Mesh unit = test::icosphere(2);
  const ClosestPointQuery closest(unit);
  for (const double scale : {0x1p-100, 0x1p100}) {
    const Mesh mesh = test::scaled(unit, scale);
    const ClosestPointQuery scaled(mesh);
    test::Random random(8);
    for (int i = 0; i < 100; ++i) {
      const Vec3 query = random.point(-2, 2);
      CHECK(scaled(scale * query).signed_distance == scale * closest(query).signed_distance);
    }
  }
}

TEST_CASE("any order of faces gives the closest point, even if declared wrongly") {
  Mesh mesh = spiky_sphere();
  const ClosestPointQuery usual(mesh);
  const ClosestPointQuery misled(mesh, FaceOrder::spatial);
  Mesh sorted = mesh;
  const std::vector<Index> order = spatial_face_order(mesh);
  for (std::size_t f = 0; f < order.size(); ++f) sorted.faces[f] = mesh.faces[order[f]];
  const ClosestPointQuery quick(sorted, FaceOrder::spatial);
  test::Random random(8);
  for (int i = 0; i < 300; ++i) {
    const Vec3 query = random.point(-1.5, 1.5);
    CHECK(misled(query).signed_distance == usual(query).signed_distance);
    CHECK(quick(query).distance == usual(query).distance);
  }
}

TEST_CASE("a mesh without faces has no closest point") {
  Mesh mesh;
  mesh.positions.emplace_back(1, 2, 3);
  CHECK_THROWS_AS(ClosestPointQuery{mesh}, InputError);
}
