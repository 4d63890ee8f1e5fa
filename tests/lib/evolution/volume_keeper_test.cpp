#include "evolution/volume_keeper.h"

#include <doctest/doctest.h>

#include "evolution/loop/stages.h"
#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

void remesh_by(double edge, Document& document) {
  IterationOptions options{.reference_edge = edge};
  options.remesh = RemeshOptions();
  remesh_in_place(document, options);
}

/// A ball of radius 1, and a distant ball of radius 0.2 with as many faces.
Document two_balls() {
  Document document;
  document.mesh = test::joined(test::icosphere(3),
                               test::moved(test::scaled(test::icosphere(3), 0.2), Vec3(100, 0, 0)));
  return document;
}

std::vector<double> component_volumes(const Mesh& mesh) {
  std::vector<double> volumes;
  for (const Mesh& part : split_components(mesh, ComponentSize::volume))
    volumes.push_back(volume(part));
  return volumes;
}

}  // namespace

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
  remesh_by(0.4, document);
  CHECK(volume(document.mesh) < 0.997 * before);
  CHECK(keeper.volume() == before);
  CHECK(keeper.restore(document));
  CHECK(document.mesh.vertex_columns.columns.empty());
  CHECK(document.mesh.face_columns.columns.empty());
  CHECK(volume(document.mesh) == doctest::Approx(before).epsilon(1e-13));
}

TEST_CASE("each component gets back its own volume") {
  Document document = two_balls();
  const std::vector<double> volumes = component_volumes(document.mesh);
  std::vector<Vec3> movements(document.mesh.positions.size(), Vec3::Zero());
  for (std::size_t v = movements.size() / 2; v < movements.size(); ++v)
    movements[v] = Vec3(0, 0, 1);
  VolumeKeeper keeper;
  keeper.begin(document.mesh, movements);
  remesh_by(0.06, document);
  // Edges of the small ball collapse. Those of the large ball are split, which keeps its volume.
  CHECK(component_volumes(document.mesh)[1] < 0.999 * volumes[1]);
  CHECK(keeper.restore(document));
  const std::vector<double> restored = component_volumes(document.mesh);
  CHECK(restored[0] == doctest::Approx(volumes[0]).epsilon(1e-13));
  CHECK(restored[1] == doctest::Approx(volumes[1]).epsilon(1e-13));
}

TEST_CASE("a component whose volume is unchanged keeps its vertices") {
  Document document = two_balls();
  const Mesh before = document.mesh;
  VolumeKeeper keeper;
  keeper.begin(document.mesh, std::vector<Vec3>(before.positions.size(), Vec3(0, 0, 1)));
  document.mesh.positions.back() *= 1.00001;
  CHECK(keeper.restore(document));
  for (std::size_t v = 0; v < before.positions.size() / 2; ++v)
    CHECK(document.mesh.positions[v] == before.positions[v]);
}

TEST_CASE("components that merge share their volume") {
  Document document = two_balls();
  const std::vector<double> volumes = component_volumes(document.mesh);
  VolumeKeeper keeper;
  keeper.begin(document.mesh, std::vector<Vec3>(document.mesh.positions.size(), Vec3(0, 0, 1)));
  // A face of the far ball counts as one of the large ball, as if cleaning had joined both.
  document.mesh.face_columns.columns[0].values.back() = 1;
  for (std::size_t v = 0; v < document.mesh.positions.size() / 2; ++v)
    document.mesh.positions[v].z() *= 0.999;
  CHECK(keeper.restore(document));
  CHECK(volume(document.mesh) == doctest::Approx(volumes[0] + volumes[1]).epsilon(1e-13));
  CHECK(component_volumes(document.mesh)[1] > 1.0001 * volumes[1]);
}

TEST_CASE("vertices that moved are moved alike if the one that moved farthest cannot do it alone") {
  Document document;
  document.mesh = test::icosphere(3);
  const double before = volume(document.mesh);
  std::vector<Vec3> movements(document.mesh.positions.size(), Vec3(0, 0, 1e-9));
  movements[0] = Vec3(0, 0, 1);
  VolumeKeeper keeper;
  keeper.begin(document.mesh, movements);
  for (Vec3& p : document.mesh.positions) p *= 0.999;
  CHECK(keeper.restore(document));
  CHECK(volume(document.mesh) == doctest::Approx(before).epsilon(1e-13));
  CHECK(document.mesh.positions[0].norm() < 1.01);
}
