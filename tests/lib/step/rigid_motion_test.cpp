#include "step/rigid_motion.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <vector>

#include "support/random.h"
#include "transformesh/transform.h"

using namespace transformesh;

namespace {

struct Plane {
  Vec3 point, normal;
  double distance, weight;
};

std::vector<Plane> random_planes(std::size_t count) {
  Random random(7);
  const auto vector = [&] {
    return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  };
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < count; ++i)
    planes.push_back(
        {vector(), vector().normalized(), 1e-5 * random.uniform(-1, 1), random.uniform(0.1, 2)});
  return planes;
}

}  // namespace

TEST_CASE("the motion is the least-squares one of Eigen's decomposition by QR") {
  const std::vector<Plane> planes = random_planes(40);
  PlaneEquations equations(Vec3(0.1, 0.2, 0.3), 0.7);
  Eigen::MatrixXd rows(40, 6);
  Eigen::VectorXd right(40);
  for (Eigen::Index i = 0; i < 40; ++i) {
    const Plane& plane = planes[static_cast<std::size_t>(i)];
    equations.add(plane.point, plane.normal, plane.distance, plane.weight);
    const double root = std::sqrt(plane.weight);
    rows.row(i) << root * plane.point.cross(plane.normal).transpose(),
        root * plane.normal.transpose();
    right[i] = root * plane.distance;
  }
  const Eigen::VectorXd expected = rows.colPivHouseholderQr().solve(right);
  const auto [motion, stability] = equations.solve();
  CHECK(stability > 0.1);
  CHECK(stability < 1);
  const Vec3 turn(motion.rotation(2, 1), motion.rotation(0, 2), motion.rotation(1, 0));
  // Angles of 1e-5 have terms of second order of 1e-10.
  CHECK((turn - expected.head<3>()).norm() < 1e-9);
  CHECK((motion.translation - expected.tail<3>()).norm() < 1e-9);
}

TEST_CASE("undetermined motions are zero") {
  PlaneEquations equations(Vec3::Zero(), 1);
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0}) equations.add({x, y, 0}, {0, 0, 1}, 0.25, 1);
  const auto [motion, stability] = equations.solve();
  CHECK(stability == doctest::Approx(0));
  CHECK((motion.translation - Vec3(0, 0, 0.25)).norm() < 1e-12);
  CHECK(motion.rotation.isIdentity(1e-12));
  CHECK(PlaneEquations(Vec3::Zero(), 1).solve().motion.rotation.isIdentity(0));
}

TEST_CASE("motions compose and stay rigid") {
  const RigidMotion turn{rotation_about({1, 2, 3}, 7).topLeftCorner<3, 3>(), Vec3(1, 0, 0)};
  RigidMotion all;
  for (int i = 0; i < 10000; ++i) all = compose(turn, all);
  CHECK((all.rotation * all.rotation.transpose()).isIdentity(1e-14));
  const RigidMotion twice = compose(turn, turn);
  CHECK((twice(Vec3(4, 5, 6)) - turn(turn(Vec3(4, 5, 6)))).norm() < 1e-14);
  CHECK(angle_deg_of(twice.rotation) == doctest::Approx(14));
  CHECK(angle_deg_of(rotation_about({0, 1, 1}, 180).topLeftCorner<3, 3>()) == doctest::Approx(180));
}
