#include "reconstruction/filled_hollows.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/photographed.h"
#include "helpers/shapes.h"
#include "reconstruction/surface_doubt.h"
#include "views/photo/photo_scene.h"

using namespace transformesh;

namespace {

constexpr double least_cosine = 0.1;

SurfaceDoubt doubt_of(const Mesh& mesh, const Mesh& photographed) {
  return surface_doubt(mesh, photo_scene(test::photographed(photographed, test::small_ring(16)), 1),
                       least_cosine);
}

/// Returns the unit ball with a flat-bottomed pit around the x axis. The radius of the pit is 0.25,
/// which is 8 pixels of a photograph.
Mesh ball_with_pit(double depth) {
  Mesh mesh = test::icosphere(5);
  for (Vec3& p : mesh.positions)
    if (p.x() > 0 && std::hypot(p.y(), p.z()) < 0.25) p.x() -= depth;
  return mesh;
}

}  // namespace

TEST_CASE("a ball fills the pit that photographs show, and only there") {
  const SurfaceDoubt doubt = doubt_of(test::icosphere(5), ball_with_pit(0.3));
  REQUIRE(doubt.filled_hollows.size() == 1);
  CHECK((doubt.filled_hollows[0].center - Vec3(1, 0, 0)).norm() < 0.15);
  CHECK(doubt.filled_hollows[0].area < 250);
}

TEST_CASE("the true surface fills no hollow, and neither does a surface that is too deep") {
  CHECK(doubt_of(test::icosphere(5), test::icosphere(5)).filled_hollows.empty());
  CHECK(doubt_of(ball_with_pit(0.3), ball_with_pit(0.3)).filled_hollows.empty());
  CHECK(doubt_of(ball_with_pit(0.3), test::icosphere(5)).filled_hollows.empty());
}

TEST_CASE("a trial that hides windows fills no hollow, and only possible hollows are tried") {
  const Mesh mesh = test::icosphere(3);
  std::vector<WindowSums> sums(mesh.positions.size(), {1, 0.1, 0.1});
  std::size_t trials = 0;
  WindowSums found;
  const auto measure = [&](const Mesh& deeper) {
    ++trials;
    for (std::size_t v = 0; v < sums.size(); ++v)
      CHECK((deeper.positions[v] - mesh.positions[v]).norm() ==
            doctest::Approx(sums[v].energy > 0.5 ? 6 * 0.03 : 0).epsilon(0.01));
    return std::vector<WindowSums>(mesh.positions.size(), found);
  };
  CHECK(filled_hollows(mesh, sums, 0.03, measure).empty());
  CHECK(trials == 0);
  // Vertices up to 0.3 from the z axis are a cap of 0.28, which is 314 squared pixels.
  std::size_t count = 0;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (mesh.positions[v].z() < 0 || std::hypot(mesh.positions[v].x(), mesh.positions[v].y()) > 0.3)
      continue;
    sums[v].energy = 0.9;
    ++count;
  }
  found = {0.2, 0.02, 0.02};
  CHECK(filled_hollows(mesh, sums, 0.03, measure).empty());
  found = {1, 0.1, 0.1};
  const auto hollows = filled_hollows(mesh, sums, 0.03, measure);
  REQUIRE(hollows.size() == 1);
  CHECK(hollows[0].size() == count);
  CHECK(trials == 2);
}
