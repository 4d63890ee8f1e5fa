/// Offsets of balls and boxes against Steiner's formula.
#include "transformesh/offset.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "evolution/loop/stages.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

constexpr double pi = std::numbers::pi;

struct Moved {
  Mesh mesh;
  OffsetResult result;
};

Moved moved_by(const Mesh& mesh, double distance, double edge = 0) {
  Document document;
  document.mesh = mesh;
  const OffsetResult result = offset(document, {.distance = distance, .edge = edge});
  CHECK(result.is_done());
  const ManifoldReport found = check_manifold(document.mesh);
  CHECK((found.is_manifold() && found.is_oriented() && found.is_closed()));
  CHECK(find_intersections(document.mesh).empty());
  const Components parts = connected_components(document.mesh);
  CHECK(parts.components.size() == result.topology.components);
  CHECK(parts.genus() == result.topology.genus);
  return {document.mesh, result};
}

double ball(double radius) { return 4.0 / 3 * pi * radius * radius * radius; }

}  // namespace

TEST_CASE("a ball grows and shrinks to a ball") {
  for (const double distance : {0.3, -0.3, -0.7}) {
    CAPTURE(distance);
    const auto [mesh, result] = moved_by(test::icosphere(4), distance);
    CHECK(volume(mesh) == doctest::Approx(ball(1 + distance)).epsilon(0.02));
    CHECK(result.deviation.most < 0.01);
    CHECK(result.deviation.missed < 0.01);
    CHECK(result.deviation.rms <= result.deviation.most);
  }
}

TEST_CASE("a box grows by Steiner's formula and shrinks to a smaller box") {
  const double d = 0.2;
  const double grown = 1 + 6 * d + 12 * pi / 4 * d * d + ball(d);
  CHECK(volume(moved_by(test::cube(), d, 0.04).mesh) == doctest::Approx(grown).epsilon(0.005));
  const auto [small, result] = moved_by(test::cube(), -d, 0.03);
  CHECK(volume(small) == doctest::Approx(0.6 * 0.6 * 0.6).epsilon(0.02));
  CHECK(result.deviation.missed < 0.06);  // corners are cut by up to two edge lengths
}

TEST_CASE("balls that are near become one, and those that are far stay two") {
  const Mesh ball = test::icosphere(3);
  const Mesh pair = test::joined(ball, test::moved(ball, {2.4, 0, 0}));
  CHECK(moved_by(pair, 0.1).result.topology.components == 2);
  CHECK(moved_by(pair, 0.4).result.topology.components == 1);
}

TEST_CASE("a cavity shrinks where the outside grows, and vanishes") {
  const Mesh hollow =
      test::joined(test::icosphere(4), test::reversed(test::scaled(test::icosphere(3), 0.5)));
  const auto [mesh, result] = moved_by(hollow, 0.2);
  CHECK(volume(mesh) == doctest::Approx(ball(1.2) - ball(0.3)).epsilon(0.02));
  CHECK(result.topology.components == 2);
}

TEST_CASE("the bar of a dumbbell vanishes, and its balls are left") {
  // A capsule of three boxes: two thick ones and a thin bar between them.
  const Mesh ends = test::joined(test::cuboid({-2, -0.5, -0.5}, {-1, 0.5, 0.5}),
                                 test::cuboid({1, -0.5, -0.5}, {2, 0.5, 0.5}));
  Mesh dumbbell = test::joined(ends, test::cuboid({-1.2, -0.1, -0.1}, {1.2, 0.1, 0.1}));
  Document document;
  document.mesh = dumbbell;
  clean_in_place(document);
  const auto [mesh, result] = moved_by(document.mesh, -0.2, 0.05);
  CHECK(result.topology.components == 2);
  CHECK(volume(mesh) == doctest::Approx(2 * 0.6 * 0.6 * 0.6).epsilon(0.06));
}

TEST_CASE("a plate that loses its rim is reported with the place; finer edges keep it") {
  // An inward offset of 1.9 leaves a box of 0.2 x 2.2 x 4.2 from one of 4 x 6 x 8.
  const Mesh box = test::cuboid(Vec3::Zero(), {4, 6, 8});
  const double left = 0.2 * 2.2 * 4.2;
  Document coarse;
  coarse.mesh = box;
  const OffsetResult lost = offset(coarse, {.distance = -1.9, .edge = 0.5});
  CHECK(lost.has_arrived);
  CHECK(lost.has_missed);
  CHECK(!lost.is_done());
  CHECK(volume(coarse.mesh) < 0.9 * left);
  // The farthest missed point is on the box that the inward offset leaves.
  const Vec3 to_middle = lost.deviation.missed_at - Vec3(2, 3, 4);
  CHECK((to_middle.cwiseAbs() - Vec3(0.1, 1.1, 2.1)).maxCoeff() ==
        doctest::Approx(0).epsilon(1e-5));
  double nearest = 1e9;
  for (const Vec3& p : coarse.mesh.positions)
    nearest = std::min(nearest, (p - lost.deviation.missed_at).norm());
  CHECK(nearest >= lost.deviation.missed - 1e-9);
  CHECK(nearest < lost.deviation.missed + 0.5);

  Document fine;
  fine.mesh = box;
  const OffsetResult kept = offset(fine, {.distance = -1.9, .edge = 0.1});
  CHECK(kept.is_done());
  CHECK(volume(fine.mesh) == doctest::Approx(left).epsilon(0.03));
}

TEST_CASE("the root mean square is that of the surface, whatever the vertices are") {
  // The faces of an icosahedron lie inside of the sphere, and its vertices on it.
  for (const double edge : {0.1, 0.3}) {
    const auto [mesh, result] = moved_by(test::icosphere(4), 0.5, edge);
    double sum = 0, area = 0;
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      // The mean over the midpoints of a face's edges is exact for quadratic polynomials.
      const auto& [a, b, c] = mesh.faces[f];
      for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        const double off = ((mesh.positions[i] + mesh.positions[j]) / 2).norm() - 1.5;
        sum += off * off * face_area(mesh, f) / 3;
      }
      area += face_area(mesh, f);
    }
    CHECK(result.deviation.rms == doctest::Approx(std::sqrt(sum / area)).epsilon(0.15));
  }
}

TEST_CASE("what vanishes, what is open and a distance of nothing are refused") {
  Document document;
  document.mesh = test::cube();
  CHECK_THROWS_AS(offset(document, {.distance = -0.6}), GoalError);
  CHECK_THROWS_AS(offset(document, {.distance = 0}), UsageError);
  CHECK_THROWS_AS(offset(document, {.distance = NAN}), UsageError);
  document.mesh = test::cube();
  document.mesh.faces.pop_back();
  CHECK_THROWS_AS(offset(document, {.distance = 0.1}), InputError);
}

TEST_CASE("an offset does not depend on threads") {
  const auto run = [&](int threads) {
    const ThreadLimit limit(threads);
    return moved_by(test::icosphere(3), 0.2).mesh;
  };
  const Mesh first = run(1), second = run(4);
  CHECK(first.positions == second.positions);
  CHECK(first.faces == second.faces);
}
