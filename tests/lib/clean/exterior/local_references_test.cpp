/// Winding numbers at points that are reached along paths through cells, compared with sums of
/// solid angles.
#include "clean/exterior/local_references.h"

#include <doctest/doctest.h>

#include <cmath>

#include "clean/box/box_part.h"
#include "helpers/arrangement_facts.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"

using namespace transformesh;

namespace {

/// Returns a function that visits the faces of a mesh near a box.
LocalReferences::VisitFaces all_of(const Mesh& mesh) {
  return [&mesh](const Vec3& low, const Vec3& high, const LocalReferences::Visit& visit) {
    const std::vector<bool> near = faces_near(mesh, {low, high});
    for (Index f = 0; f < near.size(); ++f)
      if (near[f] && !visit(triangle_of(mesh, f))) return;
  };
}

Surroundings around(const Mesh& mesh, const Eigen::AlignedBox3d& held) {
  Surroundings result;
  result.held = held;
  result.reference = {held.center() + Vec3(1e-3, 2e-3, 3e-3), 0};
  result.reference.winding =
      static_cast<int>(std::lround(test::winding_number(mesh, result.reference.position)));
  result.grid = CellGrid(.08);
  std::vector<Cell> cells;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    result.grid.find(triangle_of(mesh, f), 0, cells);
    for (const Cell cell : cells) result.covered.add(cell, 0);
  }
  return result;
}

}  // namespace

TEST_CASE(
    "points beside faces far from the box that is held have the winding numbers of solid angles") {
  const Mesh mesh = test::random_balls(4, 6);
  const Vec3 start = mesh.positions[mesh.faces[0][0]];
  const Surroundings surroundings =
      around(mesh, {start - Vec3::Constant(.05), start + Vec3::Constant(.05)});
  const LocalReferences references(surroundings, all_of(mesh));
  test::Random random(2);
  int largest = 0;
  std::size_t found = 0;
  for (int i = 0; i < 60; ++i) {
    const auto f = static_cast<Index>(random.below(mesh.faces.size()));
    const Vec3 place = (mesh.positions[mesh.faces[f][0]] + mesh.positions[mesh.faces[f][1]]) / 2;
    Vec3 last = Vec3::Zero();
    for (int attempt = 0; attempt < 4; ++attempt) {
      const auto point = references.near(place, attempt);
      if (!point) continue;
      ++found;
      CHECK((point->position - place).cwiseAbs().maxCoeff() < .09);
      CHECK(point->position != last);
      CHECK(point->winding == std::lround(test::winding_number(mesh, point->position)));
      last = point->position;
      largest = std::max(largest, point->winding);
    }
  }
  CHECK(found > 100);
  CHECK(largest > 0);
}

TEST_CASE("uncovered or unreachable cells have no reference point") {
  const Mesh mesh = test::joined(test::icosphere(2), test::moved(test::icosphere(2), {9, 0, 0}));
  const Vec3 start = mesh.positions[0];
  const Surroundings surroundings =
      around(mesh, {start - Vec3::Constant(.05), start + Vec3::Constant(.05)});
  const LocalReferences references(surroundings, all_of(mesh));
  CHECK(references.near(mesh.positions[5], 0));
  CHECK(!references.near(Vec3(0, 0, 0), 0));
  CHECK(!references.near(mesh.positions.back(), 0));
}
