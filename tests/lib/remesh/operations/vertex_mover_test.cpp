#include "remesh/operations/vertex_mover.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "mesh/coordinate_spacing.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Six equilateral triangles with sides of length 1 around the origin, which is vertex 0; vertex 1
/// is at (1, 0, 0).
Mesh hexagon() {
  Mesh mesh;
  mesh.positions.emplace_back(0, 0, 0);
  for (Index i = 0; i < 6; ++i) {
    const double angle = i * std::numbers::pi / 3;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.faces.push_back({0, i + 1, (i + 1) % 6 + 1});
  }
  return mesh;
}

struct Scene {
  EditableMesh mesh;
  EmbeddingGuard guard{mesh, 3};
  VertexMover mover{mesh, guard};
  VertexStar star;

  explicit Scene(const Mesh& input) : mesh(input) {}
  bool move(Index vertex, const Vec3& target) {
    star.gather(mesh, vertex);
    return mover.move(vertex, star, target);
  }
};

}  // namespace

TEST_CASE("the star of a hexagon has its six triangles, counter-clockwise") {
  const EditableMesh mesh(hexagon());
  VertexStar star;
  star.gather(mesh, 0);
  REQUIRE(star.size() == 6);
  CHECK((star.normal() - Vec3(0, 0, 6 * std::sqrt(3) / 2)).norm() < 1e-14);
  for (std::size_t i = 0; i < 6; ++i) {
    const VertexStar::Pair& pair = star.pairs()[i / 2];
    CHECK(pair.across_squared[i % 2] == doctest::Approx(1));
    CHECK(pair.squares[i % 2] == doctest::Approx(3));
    CHECK(star.rim(i + 1) == star.rim((i + 1) % 6));
    CHECK(roundness(star.center(), star.rim(i), star.rim(i + 1)) == doctest::Approx(1));
    CHECK(cosine_of_smallest_angle(star.center(), star.rim(i), star.rim(i + 1)) ==
          doctest::Approx(0.5));
  }
}

TEST_CASE("numbers of a star are those of its triangles one by one, for any number of them") {
  const EditableMesh mesh(test::icosphere(2));
  EditableMesh border(hexagon());
  test::Random random(7);
  VertexStar star;
  const auto check = [&](const EditableMesh& of, Index vertex) {
    star.gather(of, vertex);
    Vec3 sum = Vec3::Zero();
    double farthest = 0;
    for (std::size_t i = 0; i < star.size(); ++i) {
      const VertexStar::Pair& pair = star.pairs()[i / 2];
      const Vec3 a = star.rim(i) - star.center(), b = star.rim(i + 1) - star.center();
      const Vec3 normal = a.cross(b);
      CHECK(pair.squared[i % 2] == normal.squaredNorm());
      CHECK(pair.across_squared[i % 2] == (b - a).squaredNorm());
      CHECK(pair.squares[i % 2] == a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm());
      sum += normal;
      farthest = std::max({farthest, a.squaredNorm(), b.squaredNorm()});
    }
    CHECK(star.normal() == sum);
    CHECK(star.reach_squared() == farthest);
  };
  for (Index v = 0; v < mesh.vertex_slots(); ++v) check(mesh, v);
  for (Index v = 0; v < border.vertex_slots(); ++v) {
    border.move(v, border.position(v) + random.point(-0.1, 0.1));
    check(border, v);
  }
}

TEST_CASE("a vertex goes all the way, or half of it, or not at all") {
  Scene scene(hexagon());
  CHECK(scene.move(0, {0.5, 0, 0}));
  CHECK(scene.mesh.position(0) == Vec3(0.5, 0, 0));

  // Beyond the rim triangles turn over; half of the way leaves triangles of roundness 0.62.
  Scene half(hexagon());
  CHECK(half.move(0, {1.2, 0, 0}));
  CHECK(half.mesh.position(0) == Vec3(0.6, 0, 0));

  // Half of this way would leave a triangle of roundness 0.32, where all had 1.
  Scene none(hexagon());
  CHECK_FALSE(none.move(0, {1.6, 0, 0}));
  CHECK(none.mesh.position(0) == Vec3(0, 0, 0));
}

TEST_CASE("no normal turns by more than 60 degrees") {
  // At height h the slope against the side of a triangle is h / (sqrt 3 / 2).
  const double steepest = std::tan(std::numbers::pi / 3) * std::sqrt(3) / 2;
  Scene below(hexagon());
  CHECK(below.move(0, {0, 0, 0.98 * steepest}));
  CHECK(below.mesh.position(0).z() == 0.98 * steepest);
  Scene above(hexagon());
  CHECK(above.move(0, {0, 0, 1.02 * steepest}));
  CHECK(above.mesh.position(0).z() == 0.51 * steepest);
}

TEST_CASE("a vertex does not pass through another sheet, but stops half way in front of it") {
  const Mesh sheets = joined(hexagon(), moved(hexagon(), {0, 0, 0.4}));
  Scene scene(sheets);
  CHECK(scene.move(0, {0, 0, 0.6}));
  CHECK(scene.mesh.position(0) == Vec3(0, 0, 0.3));
  CHECK_FALSE(scene.move(0, {0, 0, 0.55}));
  CHECK(scene.mesh.position(0) == Vec3(0, 0, 0.3));
  CHECK(scene.move(0, {0, 0, -0.6}));
}

TEST_CASE("a vertex of a border moves with the faces that it has") {
  Scene scene(hexagon());
  const Vec3 target(0.9, 0.1, 0);
  CHECK(scene.move(1, target));
  CHECK(scene.mesh.position(1) == target);
}

TEST_CASE("where meshes hold floats a vertex goes to one") {
  Scene scene(hexagon());
  scene.mesh.set_coordinate(Scalar::float32);
  const Vec3 target(0.1, 0.2, 0.3);
  REQUIRE(target.x() != round_to_single(target.x()));
  CHECK(scene.move(0, target));
  CHECK(scene.mesh.position(0) == scene.mesh.rounded(target));
  CHECK(scene.mesh.position(0).x() == round_to_single(0.1));
}
