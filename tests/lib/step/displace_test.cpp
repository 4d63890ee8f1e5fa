#include "transformesh/displace.h"

#include <doctest/doctest.h>

#include <limits>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/velocity.h"

using namespace transformesh;
using doctest::Approx;

namespace {

std::vector<Vec3> random_velocities(std::size_t count, double size) {
  test::Random random(7);
  std::vector<Vec3> velocities(count);
  for (Vec3& velocity : velocities) velocity = random.point(-size, size);
  return velocities;
}

double edge_of_icosahedron() { return 1 / std::sin(2 * std::numbers::pi / 5); }

}  // namespace

TEST_CASE("a step below the clamp adds time step times velocity") {
  const Mesh before = test::icosphere(2);
  Mesh mesh = before;
  const auto velocities = random_velocities(mesh.positions.size(), 1e-3);
  const DisplaceResult result = displace(mesh, velocities, {-2, 0.2});

  double squares = 0;
  double largest = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    CHECK(mesh.positions[v] == before.positions[v] - 2 * velocities[v]);
    squares += 4 * velocities[v].squaredNorm();
    largest = std::max(largest, 2 * velocities[v].norm());
  }
  CHECK(result.moved == mesh.positions.size());
  CHECK(result.clamped == 0);
  CHECK(result.max_displacement == Approx(largest));
  CHECK(result.rms_displacement ==
        Approx(std::sqrt(squares / static_cast<double>(mesh.positions.size()))));
  CHECK(mesh.faces == before.faces);
}

TEST_CASE("the clamp is alpha times the mean edge at the vertex") {
  // All edges of an icosahedron are equal, so every vertex moves by the same length.
  const double edge = edge_of_icosahedron();
  Mesh mesh = test::icosphere(0);
  const DisplaceResult result = displace(mesh, normal_velocities(mesh, 1e9), {1, 0.3});
  for (const Vec3& p : mesh.positions) CHECK(p.norm() == Approx(1 + 0.3 * edge).epsilon(1e-14));
  CHECK(result.clamped == 12);
  CHECK(result.max_displacement == Approx(0.3 * edge));
  CHECK(result.rms_displacement == Approx(0.3 * edge));
  CHECK(result.max_clamp_share == Approx(1));
  CHECK(result.mean_edge == Approx(edge));
}

TEST_CASE("each vertex has its own clamp") {
  // The corner at the origin has three edges of length 1, the others 1, sqrt 2 and sqrt 2.
  Mesh mesh = test::tetrahedron();
  const std::vector<Vec3> velocities(4, Vec3(0, 0, 100));
  displace(mesh, velocities, {1, 0.5});
  CHECK(mesh.positions[0].z() == Approx(0.5));
  CHECK(mesh.positions[1].z() == Approx(0.5 * (1 + 2 * std::sqrt(2.0)) / 3));

  // Half of the clamp at the first vertex, zero elsewhere.
  Mesh other = test::tetrahedron();
  const DisplaceResult result =
      displace(other, std::vector<Vec3>{{0.25, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {1, 0.5});
  CHECK(result.moved == 1);
  CHECK(result.max_clamp_share == Approx(0.5));
}

TEST_CASE("nothing moves without velocity, time, clamp or edges") {
  const Mesh before = test::joined(test::icosphere(1), test::cube());
  const std::size_t count = before.positions.size();
  for (const auto& [size, time, alpha] :
       {std::tuple{0.0, 1.0, 0.2}, std::tuple{1.0, 0.0, 0.2}, std::tuple{1.0, 1.0, 0.0}}) {
    Mesh mesh = before;
    const DisplaceResult result = displace(mesh, random_velocities(count, size), {time, alpha});
    CHECK(mesh.positions == before.positions);
    CHECK(result.moved == 0);
    CHECK(result.max_displacement == 0);
  }
  Mesh lonely;
  lonely.positions = {{1, 2, 3}};
  CHECK(displace(lonely, std::vector<Vec3>{{1, 1, 1}}).moved == 0);
  CHECK(lonely.positions[0] == Vec3(1, 2, 3));
}

TEST_CASE("velocities of any finite size are clamped, others refused") {
  const double huge = std::numeric_limits<double>::max();
  Mesh mesh = test::icosphere(0);
  std::vector<Vec3> velocities(12, Vec3::Zero());
  velocities[3] = Vec3(huge, huge, huge);
  const Vec3 before = mesh.positions[3];
  const DisplaceResult result = displace(mesh, velocities, {1e10, 0.2});
  CHECK((mesh.positions[3] - before).norm() == Approx(0.2 * edge_of_icosahedron()));
  CHECK(result.moved == 1);

  velocities[3].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS(displace(mesh, velocities), doctest::Contains("vertex 3 at ("), InputError);
  CHECK_THROWS_AS(displace(mesh, std::vector<Vec3>(11, Vec3::Zero())), UsageError);
  velocities[3].y() = 0;
  CHECK_THROWS_AS(displace(mesh, velocities, {1, -0.1}), UsageError);
  CHECK_THROWS_AS(displace(mesh, velocities, {huge * 2, 0.1}), UsageError);
}

TEST_CASE("a step does not depend on the number of threads") {
  const Mesh before = test::icosphere(5);
  const auto velocities = random_velocities(before.positions.size(), 0.02);
  Mesh expected = before;
  const DisplaceResult alone = [&] {
    const ThreadLimit limit(1);
    return displace(expected, velocities);
  }();
  const ThreadLimit limit(4);
  Mesh mesh = before;
  const DisplaceResult together = displace(mesh, velocities);
  CHECK(mesh.positions == expected.positions);
  CHECK(together.rms_displacement == alone.rms_displacement);
}

TEST_CASE("velocities come from columns and are masked by a column") {
  Mesh mesh = test::tetrahedron();
  CHECK_FALSE(has_column_velocities(mesh));
  CHECK_THROWS_WITH_AS(column_velocities(mesh), doctest::Contains("'vx'"), InputError);
  mesh.vertex_columns.get("vx", Scalar::float32, 4).values = {1, 2, 3, 4};
  mesh.vertex_columns.get("vy", Scalar::float64, 4).values = {5, 6, 7, 8};
  CHECK_THROWS_WITH_AS(column_velocities(mesh), doctest::Contains("'vz'"), InputError);
  mesh.vertex_columns.get("vz", Scalar::int8, 4).values = {0, 0, 0, -1};
  REQUIRE(has_column_velocities(mesh));
  std::vector<Vec3> velocities = column_velocities(mesh);
  CHECK(velocities[0] == Vec3(1, 5, 0));
  CHECK(velocities[3] == Vec3(4, 8, -1));

  mesh.vertex_columns.get("free", Scalar::uint8, 4).values = {1, 0, 2, 0};
  apply_mask(mesh, "free", velocities);
  CHECK(velocities[1] == Vec3::Zero());
  CHECK(velocities[2] == Vec3(6, 14, 0));
  CHECK_THROWS_WITH_AS(apply_mask(mesh, "fre", velocities), doctest::Contains("vx, vy, vz, free"),
                       InputError);
}
