#include "reconstruction/fin_trial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "helpers/shapes.h"
#include "transformesh/components.h"

using namespace transformesh;

namespace {

constexpr double pixel = 0.05;

/// A unit sphere with a spike at z > 0, about four pixels thick.
Document with_spike() {
  Document document{test::icosphere(5), {}, {}};
  for (Vec3& p : document.mesh.positions)
    if (p.z() > 0) p.z() += std::exp(-(p.x() * p.x() + p.y() * p.y()) / 0.01);
  return document;
}

double height(const Mesh& mesh) {
  double highest = 0;
  for (const Vec3& p : mesh.positions) highest = std::max(highest, p.z());
  return highest;
}

/// Views observe the surface below z = 1. `outline` is that of a surface without a spike.
FinTrialStages stages(double outline) {
  return {[outline](const Mesh& mesh) {
            CarvingEvidence evidence;
            for (const Vec3& p : mesh.positions)
              evidence.of_vertex.push_back({p.z() < 1 ? 1.0 : 0.0, 0, 0});
            evidence.outline = height(mesh) > 1.5 ? 0.9 : outline;
            return evidence;
          },
          [](Document&) {}};
}

}  // namespace

TEST_CASE("an unobserved fin is removed if outlines agree no less without it") {
  for (const double outline : {0.9, 0.95}) {
    Document document = with_spike();
    CHECK(try_without_fins(document, pixel, stages(outline)));
    CHECK(height(document.mesh) < 1.02);
    CHECK(height(document.mesh) > 0.9);
    const Components parts = connected_components(document.mesh);
    CHECK(parts.components.size() == 1);
    CHECK(parts.components.front().boundary_loops == 0);
    CHECK(parts.genus() == 0);
  }
}

TEST_CASE("an unobserved fin stays if outlines agree less without it, or if cleaning fails") {
  FinTrialStages fails = stages(0.9);
  fails.clean = [](Document&) { throw std::runtime_error("nothing is left"); };
  for (const FinTrialStages& trial : {stages(0.89), fails}) {
    Document document = with_spike();
    CHECK_FALSE(try_without_fins(document, pixel, trial));
    CHECK(document.mesh.positions == with_spike().mesh.positions);
  }
}

TEST_CASE("a surface without unobserved fins is not changed") {
  for (const double size : {pixel, 0.002}) {
    Document document = with_spike();
    if (size == pixel) document.mesh = test::icosphere(5);
    const Mesh before = document.mesh;
    CHECK_FALSE(try_without_fins(document, size, stages(1)));
    CHECK(document.mesh.positions == before.positions);
  }
}
