#include "flow/conserved_volume.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Returns the volume by the divergence theorem, relative to the first vertex.
double volume_of(const Mesh& mesh, std::size_t first, std::size_t last) {
  const Vec3 origin = mesh.positions[mesh.faces[first][0]];
  double sum = 0;
  for (std::size_t f = first; f < last; ++f) {
    const auto [a, b, c] = mesh.faces[f];
    sum += (mesh.positions[a] - origin)
               .dot((mesh.positions[b] - origin).cross(mesh.positions[c] - origin));
  }
  return sum / 6;
}

std::vector<Vec3> random_motion(const Mesh& mesh, double size) {
  test::Random random(7);
  std::vector<Vec3> motion;
  for (const Vec3& p : mesh.positions) motion.push_back(size * random.point(-1, 1) - size * p);
  return motion;
}

Mesh moved(Mesh mesh, const std::vector<Vec3>& by, double factor) {
  for (std::size_t v = 0; v < by.size(); ++v) mesh.positions[v] += factor * by[v];
  return mesh;
}

/// Two balls; the second one is far away.
Mesh two_balls() {
  return test::joined(test::icosphere(2),
                      test::moved(test::scaled(test::icosphere(2), 0.1), Vec3(1000, 0, 0)));
}

}  // namespace

TEST_CASE("the volume of each component is restored, also far from the origin") {
  const Mesh mesh = two_balls();
  const std::size_t half = mesh.faces.size() / 2;
  std::vector<Vec3> motion = random_motion(mesh, 0.02);
  for (std::size_t v = mesh.positions.size() / 2; v < mesh.positions.size(); ++v)
    motion[v] = Vec3(3, 0.01 * static_cast<double>(v % 3), 0);
  const Mesh free = moved(mesh, motion, 1);
  CHECK(std::abs(volume_of(free, 0, half) / volume_of(mesh, 0, half) - 1) > 0.01);
  restore_volumes(mesh, motion);
  const Mesh kept = moved(mesh, motion, 1);
  CHECK(volume_of(kept, 0, half) == Approx(volume_of(mesh, 0, half)).epsilon(1e-13));
  CHECK(volume_of(kept, half, 2 * half) == Approx(volume_of(mesh, half, 2 * half)).epsilon(1e-10));
}

TEST_CASE("after the correction of velocities the volumes have no derivative") {
  const Mesh mesh = two_balls();
  const std::size_t half = mesh.faces.size() / 2;
  std::vector<Vec3> velocities = random_motion(mesh, 1);
  for (std::size_t v = mesh.positions.size() / 2; v < mesh.positions.size(); ++v)
    velocities[v] = (mesh.positions[v] - Vec3(1000, 0, 0)) * 2;
  const auto rate = [&](std::size_t first, std::size_t last) {
    constexpr double h = 1e-4;
    return (volume_of(moved(mesh, velocities, h), first, last) -
            volume_of(moved(mesh, velocities, -h), first, last)) /
           (2 * h);
  };
  CHECK(std::abs(rate(0, half)) > 1);
  CHECK(rate(half, 2 * half) > 0.01);
  remove_volume_rates(mesh, velocities);
  CHECK(std::abs(rate(0, half)) < 1e-6);
  CHECK(std::abs(rate(half, 2 * half)) < 1e-8);
}

TEST_CASE("only closed meshes have a volume to keep") {
  require_volume(test::cube());
  CHECK_THROWS_AS(require_volume(test::grid(2)), InputError);
}
