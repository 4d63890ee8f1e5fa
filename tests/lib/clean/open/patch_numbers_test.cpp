#include "clean/open/patch_numbers.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/measure.h"
#include "transformesh/shapes.h"

using namespace transformesh;

namespace {

/// Returns the area of the faces whose corners are all above a plane z = height.
double area_above(Mesh mesh, double height) {
  std::erase_if(mesh.faces, [&](const Face& f) {
    return std::ranges::any_of(f, [&](Index v) { return mesh.positions[v].z() <= height; });
  });
  return surface_area(mesh);
}

Mesh without_faces_below(Mesh mesh, double height) {
  std::erase_if(mesh.faces, [&](const Face& f) {
    return std::ranges::any_of(f, [&](Index v) { return mesh.positions[v].z() < height; });
  });
  return mesh;
}

}  // namespace

TEST_CASE("a small sheet does not hide a body that it cuts from border to border") {
  // The sheet cuts off a corner of an open box. The rest of the box is behind the sheet.
  Mesh box = test::cuboid(Vec3::Constant(-1), Vec3::Constant(1));
  box.faces.erase(box.faces.begin() + 2, box.faces.begin() + 4);  // the side z = 1
  Mesh sheet = test::moved(test::grid(1), {-.5, -.5, 0});
  for (Vec3& p : sheet.positions)
    p = Vec3(1, 1, 1) + p.x() * Vec3(1, -1, 0) + p.y() * Vec3(0, 0, 1) - Vec3(.1, .1, 0);
  for (const bool is_reversed : {false, true}) {
    CAPTURE(is_reversed);
    const Mesh cutter = is_reversed ? test::reversed(sheet) : sheet;
    CHECK(surface_area(clean(test::joined(box, cutter)).mesh) > .95 * surface_area(box));
  }
}

TEST_CASE("a folded body with a large hole keeps what the closed body has there") {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const double height : {-.6, -.3, 0.}) {
      CAPTURE(seed);
      CAPTURE(height);
      ShapeOptions options;
      options.kind = "folded";
      options.parameters = {"sphere"};
      options.faces = 1500;
      options.seed = seed;
      const Mesh closed = make_shape(options);
      const Mesh open = without_faces_below(closed, height);
      const double expected = area_above(clean(closed).mesh, height + .2);
      const double kept = area_above(clean(open).mesh, height + .2);
      CHECK(kept > .9 * expected);
      CHECK(kept < 1.2 * expected);
      ++compared;
    }
  CHECK(compared == 12);
}
