#include "reconstruction/handle_trial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "helpers/shapes.h"
#include "transformesh/components.h"

using namespace transformesh;

namespace {

/// Length of the loops around the tube of thin_ring() is 0.63.
Document thin_ring() { return {test::torus(1, 0.1, 80, 12), {}, {}}; }

long genus(const Document& document) { return connected_components(document.mesh).genus(); }

/// Windows at a vertex of a surface with a handle, and of one without.
struct Evidence {
  WindowSums with, without;

  HandleTrialStages stages() const {
    return {[*this](const Mesh& mesh) {
              const bool has_handle = connected_components(mesh).genus() > 0;
              return std::vector<WindowSums>(mesh.positions.size(), has_handle ? with : without);
            },
            [](Document&) {}};
  }
};

}  // namespace

TEST_CASE("a handle is removed if photographs agree clearly better without it") {
  Document document = thin_ring();
  CHECK(try_without_handles(document, 0.7, Evidence{{1, 0.3, 0}, {1, 0.2, 0}}.stages()) == 1U);
  CHECK(genus(document) == 0);
}

TEST_CASE("a handle stays if photographs agree hardly better without it, or show less") {
  for (const WindowSums& without : {WindowSums{1, 0.28, 0}, WindowSums{0.5, 0.05, 0}}) {
    Document document = thin_ring();
    CHECK(try_without_handles(document, 0.7, Evidence{{1, 0.3, 0}, without}.stages()) == 0U);
    CHECK(document.mesh.positions == thin_ring().mesh.positions);
  }
  Document document = thin_ring();
  HandleTrialStages stages = Evidence{{1, 0.3, 0}, {1, 0.1, 0}}.stages();
  stages.settle = [](Document&) { throw std::runtime_error("nothing is left"); };
  CHECK(try_without_handles(document, 0.7, stages) == 0U);
  CHECK(genus(document) == 1);
}

TEST_CASE("no pits stay where a tunnel was cut") {
  // The hole of this torus is 0.2 wide at z = 0, and has a rim of radius 1 at z = 0.9.
  Document document{test::torus(1, 0.9, 60, 60), {}, {}};
  const auto depth_of_middle = [&] {
    double depth = 1;
    for (const Vec3& p : document.mesh.positions)
      if (std::hypot(p.x(), p.y()) < 0.2) depth = std::min(depth, std::abs(p.z()));
    return depth;
  };
  CHECK(depth_of_middle() < 0.01);
  // More windows show the surface across the tunnel than its walls.
  CHECK(try_without_handles(document, 0.7, Evidence{{1, 0.3, 0}, {9, 1.8, 0}}.stages()) == 1U);
  CHECK(genus(document) == 0);
  CHECK(depth_of_middle() > 0.3);
}

TEST_CASE("handles with longer loops are not tried") {
  Document document = thin_ring();
  CHECK_FALSE(try_without_handles(document, 0.5, Evidence{{1, 0.3, 0}, {1, 0.1, 0}}.stages()));
}
