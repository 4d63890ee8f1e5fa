#include "tm/evolution/morphing.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "tm/io/mesh_io.h"
#include "tm/mesh/measure.h"
#include "tm/step/target_file.h"
#include "tm/support/error.h"

using namespace transformesh;
using test::TemporaryFolder;

namespace {

Document ball(double radius) {
  Document document;
  document.mesh = test::scaled(test::icosphere(3), radius);
  return document;
}

MorphingResult morphed(Document& document, const Target& target,
                       const MorphingOptions& options = {}, std::size_t iterations = 300) {
  Record none;
  return morph(document, target, options, {.iterations = iterations}, none);
}

}  // namespace

TEST_CASE("a ball around a torus becomes the torus") {
  Document document = ball(1.6);
  const Target target = make_target(test::torus(1, 0.4, 60, 30));
  const MorphingResult result = morphed(document, target);
  CHECK(result.stop == MorphingStop::converged);
  CHECK(result.topology == Topology{1, 1});
  CHECK(result.expected == Topology{1, 1});
  CHECK(result.agreement.fault.empty());
  CHECK(*result.agreement.to_target < edge_lengths(document.mesh).maximum / 2);
  CHECK(result.distances.displaced.moved == 0);
}

TEST_CASE("a mesh that is there already needs two iterations") {
  Document document = ball(1);
  const MorphingResult result = morphed(document, make_target(test::icosphere(4)));
  CHECK(result.stop == MorphingStop::converged);
  CHECK(result.iterations == 2);
}

TEST_CASE("a part of the target that is out of reach is no convergence, and the place is named") {
  const Mesh ball_there = test::moved(test::icosphere(3), Vec3(10, 0, 0));
  const Mesh target = test::joined(test::icosphere(3), ball_there);
  Document document = ball(1.1);
  const MorphingResult result = morphed(document, make_target(target));
  CHECK(result.stop == MorphingStop::stalled);
  CHECK(result.iterations < 60);
  CHECK(result.expected == Topology{2, 0});
  CHECK(result.agreement.fault.find(
            "components 1 and genus 0, but those of the target are 2 and 0") == 0);
  CHECK(result.agreement.fault.find("at (11, ") != std::string::npos);
}

TEST_CASE(
    "the limit of iterations leaves a run that continues to the same bytes, from any of them") {
  const Target target = make_target(test::torus(1, 0.4, 40, 20));
  Document whole = ball(1.6);
  MorphingOptions options;
  options.scales = 2;
  const MorphingResult result = morphed(whole, target, options);
  CHECK(result.stop == MorphingStop::converged);

  const TemporaryFolder folder;
  RecordOptions kept;
  kept.state = folder / "state";
  kept.resume = true;
  options.iteration.reference_edge = measured_reference_edge(ball(1.6).mesh);
  Document document = ball(1.6);
  for (std::size_t limit = 3;; limit += 9) {
    Record record(kept);
    const MorphingResult part = morph(document, target, options, {.iterations = limit}, record);
    if (part.stop != MorphingStop::iteration_limit) break;
    REQUIRE(limit < 200);
  }
  CHECK(write_mesh(document).bytes == write_mesh(whole).bytes);
  CHECK(folder.is_empty());
}

TEST_CASE("a target without faces has no topology to be reached") {
  Mesh points;
  points.positions = test::icosphere(4).positions;
  CHECK_FALSE(topology_of_target(make_target(points)));
  CHECK(topology_of_target(make_target(test::torus(1, 0.4, 40, 20))) == Topology{1, 1});
  // Neither has one that is open.
  Mesh open = test::icosphere(3);
  open.faces.pop_back();
  CHECK_FALSE(topology_of_target(make_target(open)));
}

TEST_CASE("a ball around a cube becomes the cube, unless its edges are to stay cut off") {
  const Target target = make_target(test::moved(test::cube(), Vec3(-0.5, -0.5, -0.5)));
  Document document = ball(1);
  const MorphingResult result = morphed(document, target);
  CHECK(result.stop == MorphingStop::converged);
  CHECK(result.aligned > 50);
  CHECK(*result.agreement.to_target < 1e-9);
  CHECK(*result.agreement.from_target < 1e-9);
  CHECK(volume(document.mesh) == doctest::Approx(1).epsilon(1e-9));

  Document cut_off = ball(1);
  MorphingOptions options;
  options.features = Features::off;
  const MorphingResult without = morphed(cut_off, target, options);
  CHECK(without.aligned == 0);
  CHECK(without.iterations == result.iterations);
  CHECK(*without.agreement.from_target > 0.05);
}
