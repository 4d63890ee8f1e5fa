#include "reconstruction/carving.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// One window at each vertex, with this excess.
CarvingEvidence uniform(const Mesh& mesh, double excess) {
  return {std::vector<WindowSums>(mesh.positions.size(), {1, excess, 0}), 1};
}

/// Photographs that contradict a ball until its radius is at most `radius`.
CarvingEvidence contradicts_beyond(const Mesh& mesh, double radius) {
  return uniform(mesh, mesh.positions.front().norm() > radius ? 1 : 0.1);
}

void keep(Document& /*document*/) {}

}  // namespace

TEST_CASE("a surface recedes until photographs confirm it") {
  // Rounds end at 0.92, 0.84, 0.76 and 0.68.
  for (const auto& [radius, end] : {std::pair(0.9, 0.84), {0.8, 0.76}, {0.7, 0.68}}) {
    Document document;
    document.mesh = test::icosphere(3);
    const auto measure = [at = radius](const Mesh& mesh) { return contradicts_beyond(mesh, at); };
    CHECK(carve(document, {measure, keep, keep, 0.08}));
    for (const Vec3& p : document.mesh.positions)
      CHECK(p.norm() == doctest::Approx(end).epsilon(1e-3));
  }
}

TEST_CASE("a surface that photographs confirm is not carved") {
  Document document;
  document.mesh = test::icosphere(3);
  const auto confirms = [](const Mesh& mesh) { return uniform(mesh, 0.1); };
  const auto fails = [](Document&) { FAIL("nothing is to be carved"); };
  CHECK_FALSE(carve(document, {confirms, fails, fails, 0.08}));
}

TEST_CASE("carving is undone if the outline shrinks or no more is confirmed") {
  Document document;
  document.mesh = test::icosphere(3);
  const Document before = document;
  const auto uncovers = [](const Mesh& mesh) {
    CarvingEvidence evidence = contradicts_beyond(mesh, 0.7);
    evidence.outline = mesh.positions.front().norm();
    return evidence;
  };
  CHECK_FALSE(carve(document, {uncovers, keep, keep, 0.08}));
  CHECK(document.mesh.positions == before.mesh.positions);
  const auto never_confirms = [](const Mesh& mesh) { return uniform(mesh, 1); };
  CHECK_FALSE(carve(document, {never_confirms, keep, keep, 0.08}));
  CHECK(document.mesh.positions == before.mesh.positions);
}
