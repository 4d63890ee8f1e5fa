/// Patches within a distance of the input, checked by dense samples against all faces
/// (sampled_distance.h).
#include "remesh/guards/error_bound.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/random.h"
#include "helpers/sampled_distance.h"
#include "helpers/shapes.h"
#include "lib/remesh/double_cone.h"
#include "remesh/operations/edge_collapser.h"

using namespace transformesh;

namespace {

constexpr double longest = 10;

/// Collapses random edges within the error, and checks the surface after every 100 tries and at the
/// end.
struct Collapses {
  Collapses(const Mesh& mesh, double error)
      : input(mesh), edited(mesh), bound(edited, input, error), allowed(error) {}

  int run(int tries, bool moves) {
    EmbeddingGuard guard(edited, longest);
    const VertexRoles roles(edited, false);
    EdgeCollapser collapser(edited, guard, roles, longest, &bound);
    test::Random random(7);
    int done = 0;
    for (int i = 0; i < tries; ++i) {
      const auto h = static_cast<Index>(random.below(edited.halfedge_slots()));
      if (!edited.has_halfedge(h)) continue;
      const Vec3 &from = edited.position(edited.source(h)), &to = edited.position(edited.target(h));
      const Vec3 shift = moves ? random.point(-allowed, allowed) : Vec3(Vec3::Zero());
      done += collapser.collapse_to(h, 0.5 * from + 0.5 * to + shift) != no_index;
      if (i % 100 == 0) judge();
    }
    judge();
    return done;
  }
  double distance() const {
    const Mesh now = edited.to_mesh();
    return std::max(test::sampled_distance(input, now, 6), test::sampled_distance(now, input, 6));
  }
  void judge() const { CHECK(distance() <= allowed); }

  Mesh input;
  EditableMesh edited;
  ErrorBound bound;
  double allowed;
};

}  // namespace

TEST_CASE("the bound holds after each collapse, and is nearly reached") {
  Mesh ball = test::icosphere(2);
  test::Random random(3);
  for (Vec3& p : ball.positions) p += random.point(-0.02, 0.02);
  for (const double error : {0.02, 0.1}) {
    CAPTURE(error);
    Collapses collapses(ball, error);
    CHECK(collapses.run(600, true) > 10);
    CHECK(collapses.bound.refused() > 50);
    const double certified = collapses.bound.certified();
    CHECK(certified <= error);
    CHECK(collapses.distance() <= certified);
    CHECK(collapses.distance() > 0.5 * error);
  }
}

TEST_CASE("the bound holds at vertices of high valence") {
  Collapses collapses(test::double_cone(300), 0.01);
  CHECK(collapses.run(400, false) > 100);
  CHECK(collapses.bound.certified() <= 0.01);
}

TEST_CASE("a border may not move away either") {
  Mesh sheet = test::grid(8);
  Collapses collapses(sheet, 0.03);
  CHECK(collapses.run(600, true) > 10);
  CHECK(collapses.bound.refused() > 50);
}

TEST_CASE("faces in one plane are certified at a distance of rounding size") {
  // In the interior of a square, merged vertices stay in the plane.
  Collapses collapses(test::grid(10), 1e-9);
  CHECK(collapses.run(400, false) > 30);
  CHECK(collapses.bound.certified() <= 1e-9);
}

TEST_CASE("a distance below rounding errors allows nothing") {
  Collapses collapses(test::moved(test::grid(6), {1e6, 0, 0}), 1e-8);
  CHECK(collapses.run(200, false) == 0);
}
