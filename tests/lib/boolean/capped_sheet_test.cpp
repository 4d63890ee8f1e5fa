/// Parts of sheets, closed by a solid, against closed forms and winding numbers by solid angles.
#include "boolean/capped_sheet.h"

#include <doctest/doctest.h>

#include <numbers>
#include <string>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

Mesh capped(const Mesh& sheet, const Mesh& solid, SheetSide side) {
  BooleanOptions options;
  options.cap = true;
  const Mesh result = cut_sheet({&sheet, "sheet"}, {&solid, "solid"}, side, options).mesh;
  const test::Count count = test::count(result);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK(find_intersections(result).empty());
  return result;
}

std::string refusal(const Mesh& sheet, const Mesh& solid, SheetSide side) {
  try {
    capped(sheet, solid, side);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// A square of side 20 around the z axis that faces upwards.
Mesh plane(double z) { return test::moved(test::scaled(test::grid(2), 20), Vec3(-10, -10, z)); }

Mesh box(double low, double high) {
  return test::cuboid(Vec3::Constant(low), Vec3::Constant(high));
}

}  // namespace

TEST_CASE("a plane through a ball leaves half of it") {
  const Mesh ball = test::icosphere(4);
  const double volume = test::signed_volume(ball);
  CHECK(volume == doctest::Approx(4 * std::numbers::pi / 3).epsilon(0.01));
  CHECK(test::signed_volume(capped(plane(0), ball, SheetSide::inside)) ==
        doctest::Approx(volume / 2));
}

TEST_CASE("a plane through a box with a cavity leaves the part below") {
  const Mesh solid = test::joined(box(0, 4), test::reversed(box(1, 3)));
  CHECK(test::signed_volume(capped(plane(2), solid, SheetSide::inside)) == doctest::Approx(32 - 4));
  CHECK(test::signed_volume(capped(plane(3.5), solid, SheetSide::inside)) ==
        doctest::Approx(56 - 8));
  CHECK(test::signed_volume(capped(plane(0.5), solid, SheetSide::inside)) == doctest::Approx(8));
  CHECK(capped(plane(5), solid, SheetSide::inside).faces.empty());
}

TEST_CASE("two planes that face away from each other leave the slab between them") {
  const Mesh sheet = test::joined(plane(3), test::reversed(plane(1)));
  CHECK(test::signed_volume(capped(sheet, box(0, 4), SheetSide::inside)) == doctest::Approx(32));
  const Mesh alike = test::joined(plane(3), plane(1));
  CHECK(refusal(alike, box(0, 4), SheetSide::inside).starts_with("a region at ("));
}

TEST_CASE("a region between a sheet and the outside of a solid is capped by the solid") {
  // A box without its bottom, which stands in another one.
  Mesh hood = test::moved(box(0, 2), Vec3(1, 1, 3));
  std::erase_if(hood.faces, [&](const Face& face) {
    return hood.positions[face[0]].z() == 3 && hood.positions[face[1]].z() == 3 &&
           hood.positions[face[2]].z() == 3;
  });
  REQUIRE(hood.faces.size() == 10);
  CHECK(test::signed_volume(capped(hood, box(0, 4), SheetSide::outside)) == doctest::Approx(4));
  CHECK(refusal(hood, box(0, 4), SheetSide::inside).starts_with("the sheet ends inside the solid"));
  CHECK(refusal(test::reversed(hood), box(0, 4), SheetSide::outside) ==
        "the region behind the sheet is not bounded: the sheet may be reversed");
  CHECK(refusal(plane(2), box(0, 4), SheetSide::outside)
            .starts_with("the sheet ends outside the solid"));
}

TEST_CASE("closed sheets give the intersection and the difference, by solid angles") {
  std::size_t sampled = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    // The parts of the solid overlap, so the solid is one body, and no sheet encloses all of it. An
    // enclosed body would be missing from the result, because no sheet meets it.
    const auto ball = [&](double least, double most, const Vec3& at) {
      return test::moved(test::scaled(test::icosphere(1), random.uniform(least, most)), at);
    };
    const Mesh sheet = ball(0.4, 0.8, random.point(-1, 1).normalized());
    Mesh solid = ball(0.5, 1, random.point(-0.2, 0.2));
    for (int i = 0; i < 2; ++i) solid = test::joined(solid, ball(0.5, 1, random.point(-0.2, 0.2)));
    const Mesh inside = capped(sheet, solid, SheetSide::inside);
    const Mesh outside = capped(sheet, solid, SheetSide::outside);
    for (int i = 0; i < 200; ++i) {
      const Vec3 point = random.point(-1.5, 1.5);
      const auto contains = [&](const Mesh& mesh) {
        return test::winding_number(mesh, point) > 0.5;
      };
      const bool is_in_sheet = contains(sheet), is_in_solid = contains(solid);
      CHECK(contains(inside) == (is_in_sheet && is_in_solid));
      CHECK(contains(outside) == (is_in_sheet && !is_in_solid));
      sampled += is_in_sheet ? 1 : 0;
    }
  }
  CHECK(sampled > 50);
}
