#include "step/registration.h"

#include <doctest/doctest.h>

#include <string>

#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("the overlap ends where distances jump") {
  // 60 of 100 samples are 0.01 away, 30 are 1 away, and 10 have no partner.
  std::vector<double> squares(60, 1e-4);
  squares.insert(squares.end(), 30, 1);
  const Overlap overlap = overlap_of(squares, 100);
  CHECK(overlap.count == 60);
  CHECK(overlap.mean_square == doctest::Approx(1e-4));
  CHECK(overlap_of(std::vector<double>(90, 0.0), 100).count == 90);
  // A few accidental matches are no overlap.
  std::vector<double> few(5, 0.0);
  few.insert(few.end(), 95, 1);
  CHECK(overlap_of(few, 100).count == 100);
}

TEST_CASE("a registration converges to the right position, and reports each iteration") {
  const Mesh box = test::cuboid({0, 0, 0}, {0.3, 0.5, 0.7});
  const RegistrationSurface surface(box);
  RigidMotion start;
  start.translation = Vec3(0.02, -0.01, 0.03);
  Registration registration(surface, oriented_samples(box, 500), start);
  int reports = 0;
  const int iterations = registration.run(50, [&](int) { ++reports; });
  CHECK(iterations == reports);
  CHECK(registration.has_converged());
  CHECK(registration.motion().translation.norm() < 1e-9);
  CHECK(registration.overlap().count == 500);
  CHECK_FALSE(Registration(surface, oriented_samples(box, 500), start).has_converged());
}

TEST_CASE("partners on a border of the reference, and samples that face away, do not count") {
  Mesh square;
  square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.faces = {{0, 1, 2}, {0, 2, 3}};
  const RegistrationSurface surface(square);
  CHECK_FALSE(surface.closest({0.5, 0.25, 0.1}).is_on_border);
  CHECK_FALSE(surface.closest({0.5, 0.5, 0.1}).is_on_border);  // the diagonal
  CHECK(surface.closest({0.5, -0.1, 0}).is_on_border);
  CHECK(surface.closest({2, 2, 0}).is_on_border);
  const std::vector<OrientedPoint> away(200, {{0.5, 0.25, 0.1}, {0, 0, -1}});
  Registration registration(surface, away, {});
  CHECK_THROWS_AS(registration.run(1, [](int) {}), GoalError);
}

TEST_CASE("too few points are reported as such") {
  const Mesh cube = test::cube();
  const RegistrationSurface surface(cube);
  const std::vector<OrientedPoint> few(8, {{0.5, 0.25, 1}, {0, 0, 1}});
  const Registration registration(surface, few, {});
  try {
    registration.overlap();
    FAIL("eight points are too few");
  } catch (const GoalError& error) {
    CHECK(std::string(error.what()).find("only 8 points") != std::string::npos);
  }
}
