#include "step/morph_check.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

// Makes a target without the checks of make_target(), which refuses some of these meshes.
Target target_of(Mesh mesh) {
  Target target;
  target.mesh = std::move(mesh);
  return target;
}

// Gives each face three vertices of its own, as in STL.
Mesh soup_of(const Mesh& mesh) {
  Mesh soup;
  for (const Face& face : mesh.faces) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : face) soup.positions.push_back(mesh.positions[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  return soup;
}

Mesh moved(Mesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

}  // namespace

TEST_CASE("a closed target causes no warning, also as a soup or as points") {
  CHECK(check_target(target_of(test::icosphere(2)), "a.ply").empty());
  CHECK(check_target(target_of(soup_of(test::icosphere(2))), "a.ply").empty());
  Mesh points = test::icosphere(2);
  points.faces.clear();
  CHECK(check_target(target_of(points), "a.ply").empty());
}

TEST_CASE("targets that do not agree which side is outside, or are inside out, are refused") {
  Mesh mixed = test::icosphere(2);
  std::swap(mixed.faces[7][0], mixed.faces[7][1]);
  for (const Mesh& mesh : {mixed, soup_of(mixed)}) {
    CHECK_THROWS_WITH_AS(check_target(target_of(mesh), "a.ply"),
                         doctest::Contains("the target a.ply is not oriented"), InputError);
    CHECK_THROWS_WITH_AS(check_source(mesh, target_of(test::icosphere(2)), "a.ply"),
                         doctest::Contains("the source a.ply is not oriented"), InputError);
  }
  const Mesh reversed = soup_of(test::reversed(test::cube()));
  CHECK_THROWS_WITH_AS(check_target(target_of(reversed), "a.ply"), doctest::Contains("inside out"),
                       InputError);
}

TEST_CASE("open and self-intersecting targets cause warnings with numbers") {
  Mesh open = test::icosphere(2);
  open.faces.pop_back();
  auto warnings = check_target(target_of(open), "a.ply");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].sentence.starts_with("the target a.ply is open, with 3 border edges: "));
  CHECK(warnings[0].kind == ErrorKind::target_open);
  const Mesh crossing =
      test::joined(test::icosphere(1), moved(test::icosphere(1), {0.9, 0.1, 0.05}));
  warnings = check_target(target_of(crossing), "");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].sentence.starts_with("the target intersects itself at "));
}

TEST_CASE("a source apart from the target causes a warning, one that touches its box does not") {
  const Target target = target_of(test::cube());
  const double width = bounding_box(target.mesh).max().x() - bounding_box(target.mesh).min().x();
  CHECK(check_source(moved(test::cube(), {width, 0, 0}), target, "b.ply").empty());
  const auto warnings = check_source(moved(test::cube(), {0, 0, 1.01 * width}), target, "b.ply");
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].kind == ErrorKind::source_apart);
}
