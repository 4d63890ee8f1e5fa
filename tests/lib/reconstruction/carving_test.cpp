#include "reconstruction/carving.h"

#include <doctest/doctest.h>

#include <cmath>

#include "evolution/loop/stages.h"
#include "helpers/shapes.h"
#include "reconstruction/image_scales.h"
#include "transformesh/components.h"

using namespace transformesh;

namespace {

constexpr double edge = 0.08;

/// Two bodies that a bridge with a radius of a quarter joins.
Document bodies_with_bridge() {
  Document document;
  document.mesh = test::icosphere(4);
  for (Vec3& p : document.mesh.positions) {
    const double width = 0.25 + 0.75 * std::min(1.0, std::pow(p.x() / 0.4, 2));
    p = Vec3(1.5 * p.x(), width * p.y(), width * p.z());
  }
  return document;
}

/// Sums of one window at each vertex, with this excess.
std::vector<WindowSums> uniform(const Mesh& mesh, double excess) {
  return std::vector<WindowSums>(mesh.positions.size(), {1, excess, 0});
}

/// Photographs that contradict the surface between the planes x = -0.3 and x = 0.3.
CarvingEvidence contradicts_bridge(const Mesh& mesh) {
  std::vector<WindowSums> sums;
  for (const Vec3& p : mesh.positions) sums.push_back({1, std::abs(p.x()) < 0.3 ? 1.0 : 0.0, 0});
  return {sums, 1};
}

void settle(Document& document) {
  clean_in_place(document);
  remesh_to(document, edge);
}

std::size_t components_of(const Document& document) {
  return connected_components(document.mesh).components.size();
}

}  // namespace

TEST_CASE("vertices move inwards by how much photographs disagree") {
  for (const auto& [excess, share] :
       {std::pair(0.0, 0.0), {0.4, 0.0}, {0.6, 0.5}, {0.8, 1.0}, {1.0, 1.0}}) {
    Mesh mesh = test::icosphere(3);
    move_contradicted_inwards(mesh, uniform(mesh, excess), 0.1);
    for (const Vec3& p : mesh.positions)
      CHECK(p.norm() == doctest::Approx(1 - 0.1 * share).epsilon(1e-3));
  }
  Mesh mesh = test::icosphere(3);
  const std::vector<Vec3> before = mesh.positions;
  move_contradicted_inwards(mesh, std::vector<WindowSums>(before.size()), 0.1);
  CHECK(mesh.positions == before);
}

TEST_CASE("a bridge that photographs contradict is carved, and the bodies stay") {
  Document document = bodies_with_bridge();
  settle(document);
  REQUIRE(components_of(document) == 1);
  CHECK(carve(document, {contradicts_bridge, settle, settle, edge}));
  CHECK(components_of(document) == 2);
  double farthest = 0;
  for (const Vec3& p : document.mesh.positions) farthest = std::max(farthest, std::abs(p.x()));
  CHECK(farthest > 1.4);
}

TEST_CASE("a surface that photographs confirm is not carved") {
  Document document = bodies_with_bridge();
  const auto confirms = [](const Mesh& mesh) { return CarvingEvidence{uniform(mesh, 0.1), 1}; };
  const auto fails = [](Document&) { FAIL("nothing is to be carved"); };
  CHECK_FALSE(carve(document, {confirms, fails, fails, edge}));
}

TEST_CASE("carving is undone if the outline or confirmed windows get lost") {
  const Document before = bodies_with_bridge();
  Document document = before;
  double outline = 1;
  const auto shrinks = [&](const Mesh& mesh) {
    CarvingEvidence evidence = contradicts_bridge(mesh);
    evidence.outline = outline -= 0.01;
    return evidence;
  };
  CHECK_FALSE(carve(document, {shrinks, settle, settle, edge}));
  CHECK(document.mesh.positions == before.mesh.positions);
  const auto contradicts_all = [](const Mesh& mesh) {
    return CarvingEvidence{uniform(mesh, mesh.positions.size() > 100 ? 0.9 : 1), 1};
  };
  CHECK_FALSE(carve(document, {contradicts_all, settle, settle, edge}));
  CHECK(document.mesh.positions == before.mesh.positions);
}
