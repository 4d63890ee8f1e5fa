#include "evolution/volume_keeper.h"

#include <doctest/doctest.h>

#include "evolution/loop/stages.h"
#include "helpers/shapes.h"
#include "transformesh/measure.h"

using namespace transformesh;

TEST_CASE("a mesh is moved to a volume up to rounding") {
  Mesh mesh = test::icosphere(3);
  const double goal = 1.02 * volume(mesh);
  REQUIRE(move_to_volume(mesh, goal, std::vector<double>(mesh.positions.size(), 1), 0.1));
  CHECK(volume(mesh) == doctest::Approx(goal).epsilon(1e-13));
}

TEST_CASE("vertices with weight 0 stay where they are") {
  Mesh mesh = test::icosphere(3);
  const Mesh before = mesh;
  std::vector<double> weights;
  for (const Vec3& p : mesh.positions) weights.push_back(p.z() > 0 ? 1 : 0);
  const double goal = 1.001 * volume(mesh);
  REQUIRE(move_to_volume(mesh, goal, weights, 0.1));
  CHECK(volume(mesh) == doctest::Approx(goal).epsilon(1e-13));
  for (std::size_t v = 0; v < weights.size(); ++v)
    CHECK((mesh.positions[v] == before.positions[v]) == (weights[v] == 0));
}

TEST_CASE("a mesh that would have to move too far is left as it is") {
  Mesh mesh = test::icosphere(3);
  const Mesh before = mesh;
  CHECK_FALSE(
      move_to_volume(mesh, 2 * volume(mesh), std::vector<double>(mesh.positions.size(), 1), 0.1));
  CHECK(mesh.positions == before.positions);
}

TEST_CASE("what remeshing takes of the volume is restored, and the column goes") {
  Document document;
  document.mesh = test::icosphere(3);
  const double before = volume(document.mesh);
  VolumeKeeper keeper;
  keeper.begin(document.mesh, std::vector<Vec3>(document.mesh.positions.size(), Vec3(0, 0, 1)));
  CHECK(document.mesh.vertex_columns.columns.size() == 1);
  IterationOptions options{.reference_edge = 0.4};
  options.remesh = RemeshOptions();
  remesh_in_place(document, options);
  CHECK(volume(document.mesh) < 0.997 * before);
  CHECK(keeper.volume() == before);
  CHECK(keeper.restore(document));
  CHECK(document.mesh.vertex_columns.columns.empty());
  CHECK(volume(document.mesh) == doctest::Approx(before).epsilon(1e-13));
}
