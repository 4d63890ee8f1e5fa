/// Damaged solids after repair, compared with the originals. Topology is counted, and CGAL finds
/// intersections.
#include "transformesh/repair.h"

#include <doctest/doctest.h>

#include <functional>

#include "corpus/repair/damage.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/select.h"

using namespace transformesh;

namespace {

Mesh bowl() {
  Mesh ball = test::icosphere(3);
  std::erase_if(ball.faces, [&](const Face& face) { return ball.positions[face[0]].z() > 0.2; });
  return ball;
}

/// Applies the operations of the steps without repair().
Mesh replayed(Mesh mesh, const std::vector<RepairStep>& steps) {
  struct Apply {
    Mesh& mesh;
    void operator()(const StitchOptions& options) const { stitch(mesh, options); }
    void operator()(const FillOptions& options) const { fill_holes(mesh, options); }
    void operator()(const CleanOptions& options) const { mesh = clean(mesh, options).mesh; }
    void operator()(const SelectionOptions& options) const { select(mesh, options); }
  };
  for (const RepairStep& step : steps) std::visit(Apply{mesh}, step.operation);
  return mesh;
}

/// Unit cubes in a block of n^3 cells that touch; `is_used(number)` selects them, and cubes for
/// which is_inward(number) is true are inside out.
Mesh cubes(int n, const std::function<bool(int)>& is_used,
           const std::function<bool(int)>& is_inward) {
  Mesh mesh;
  for (int i = 0; i < n * n * n; ++i) {
    if (!is_used(i)) continue;
    const Mesh cube = test::moved(test::cube(), Vec3(i % n, i / n % n, i / (n * n)));
    mesh = test::joined(mesh, is_inward(i) ? test::reversed(cube) : cube);
  }
  return mesh;
}

}  // namespace

TEST_CASE("each kind of damage is repaired, and its steps give the same mesh") {
  const std::vector<corpus::Solid> solids = corpus::solids();
  std::size_t number = 0;
  for (const corpus::Damage& damage : corpus::damages()) {
    const corpus::Solid& solid = solids[number++ % solids.size()];
    CAPTURE(damage.name);
    CAPTURE(solid.name);
    const Mesh input = damage.apply(solid.mesh, 11);
    const RepairResult result = repair(input);
    CHECK(corpus::fault_of(result.mesh, damage.volume * solid.volume) == "");
    const Mesh again = replayed(input, result.steps);
    CHECK(again.positions == result.mesh.positions);
    CHECK(again.faces == result.mesh.faces);
  }
}

TEST_CASE("a solid is unchanged, and a soup of it has the same triangles") {
  for (const corpus::Solid& solid : corpus::solids()) {
    const RepairResult result = repair(solid.mesh);
    CHECK(result.steps.empty());
    CHECK(result.same_triangles);
    CHECK(result.mesh.positions == solid.mesh.positions);
    CHECK(result.mesh.faces == solid.mesh.faces);
    CHECK(result.volume_after == doctest::Approx(solid.volume));
    const RepairResult joined = repair(test::soup_of(solid.mesh));
    CHECK(joined.same_triangles);
    CHECK(joined.steps.size() == 1);
  }
  CHECK_FALSE(repair(test::reversed(test::cube())).same_triangles);
}

TEST_CASE("threads do not change the result") {
  const Mesh input = corpus::damages().back().apply(test::icosphere(3), 5);
  const Mesh one = [&] {
    const ThreadLimit limit(1);
    return repair(input).mesh;
  }();
  const ThreadLimit limit(4);
  CHECK(repair(input).mesh.positions == one.positions);
}

TEST_CASE("open meshes stay open, clean and oriented if holes are to stay") {
  Mesh mesh = bowl();
  for (std::size_t f = 0; f < mesh.faces.size(); f += 3)
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  const Mesh open = repair(mesh, {.keep_open = true}).mesh;
  const ManifoldReport found = check_manifold(open);
  CHECK(found.is_manifold());
  CHECK(found.is_oriented());
  Mesh joined = bowl();
  stitch(joined);
  CHECK(found.boundary_loops == check_manifold(joined).boundary_loops);
  CHECK(open.faces.size() == mesh.faces.size());
}

TEST_CASE("a large hole gets a flat patch, not a dome") {
  const RepairResult result = repair(bowl());
  CHECK(corpus::fault_of(result.mesh, 0) == "");
  for (const Vec3& point : result.mesh.positions) CHECK(point.z() < 0.5);
}

TEST_CASE("a result that is too far from the input is refused with the place") {
  CHECK_NOTHROW(repair(bowl(), {.max_change = 1}));
  CHECK_THROWS_WITH_AS(repair(bowl(), {.max_change = 0.1}),
                       doctest::Contains("away from the input at ("), GoalError);
  CHECK_THROWS_AS(repair(bowl(), {.max_change = 0}), UsageError);
}

TEST_CASE("sheets that enclose nothing, and meshes without faces, are refused") {
  CHECK_THROWS_AS(repair(test::grid(3)), GoalError);
  CHECK_THROWS_AS(repair(Mesh()), GoalError);
}

TEST_CASE("a mesh that is a single point is refused") {
  Mesh mesh;
  mesh.positions.assign(3, Vec3(1, 2, 3));
  mesh.faces = {{0, 0, 0}};
  CHECK_THROWS_WITH_AS(repair(mesh), doctest::Contains("no face has three different corners"),
                       GoalError);
  mesh.faces = {{0, 1, 2}};
  CHECK_THROWS_WITH_AS(repair(mesh), doctest::Contains("they have no area"), GoalError);
}

TEST_CASE("open boxes that touch or overlap at their borders stay separate bodies") {
  const auto open_box = [](const Vec3& low, const Vec3& high) {
    Mesh box = test::cuboid(low, high);
    cut_open(box, {{0, 0, 1}, 0});
    return box;
  };
  // The second box touches the first one at x = 2. The third one has a border edge in common with
  // the first one, in the same direction.
  const Mesh boxes =
      test::joined(test::joined(open_box({0, 0, -1}, {2, 2, 2}), open_box({2, 0, -2}, {3, 1, 2})),
                   open_box({1, -1, -1}, {2, 2, 1}));
  CHECK(test::signed_volume(repair(boxes).mesh) == doctest::Approx(8 + 2 + 1).epsilon(1e-12));
}

TEST_CASE("walls between cubes that touch are no second side of a surface") {
  const auto all = [](int) { return true; };
  const auto none = [](int) { return false; };
  const auto third = [](int i) { return i % 3 == 0; };
  const auto some = [](int i) { return i * 7919 % 64 < 34; };
  for (const Mesh& whole : {cubes(4, all, none), cubes(4, all, third)}) {
    const RepairResult result = repair(whole);
    CHECK(volume(result.mesh) == doctest::Approx(64));
    CHECK(result.mesh.faces.size() == 6 * 16 * 2);
    CHECK(connected_components(result.mesh).components.size() == 1);
  }
  const double cells = static_cast<double>(cubes(4, some, none).faces.size()) / 12;
  CHECK(volume(repair(cubes(4, some, third)).mesh) == doctest::Approx(cells));
  CHECK(volume(repair(test::soup_of(cubes(4, some, none))).mesh) == doctest::Approx(cells));
  Mesh copied = cubes(4, some, none);
  for (std::size_t f = 0, n = copied.faces.size(); f < n; f += 10)
    copied.faces.push_back(copied.faces[f]);
  CHECK(volume(repair(copied).mesh) == doctest::Approx(cells));
  Mesh open = cubes(4, some, none);
  open.faces.pop_back();
  CHECK(volume(repair(open).mesh) == doctest::Approx(cells));
}
