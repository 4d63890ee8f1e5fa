// Patches of open sheets relative to a closed body and to each other.
#include "clean/open/open_patches.h"

#include <doctest/doctest.h>

#include "helpers/arrangement_facts.h"

using namespace transformesh;

namespace {

/// A square sheet in the plane z = height around the z axis.
Mesh sheet(double half, double height) {
  const Mesh unit = test::moved(test::grid(1), {-.5, -.5, 0});
  return test::moved(test::scaled(unit, 2 * half), {0, 0, height});
}

/// Returns the area of the kept pieces in the plane z = height.
double kept_area(const Arrangement& arrangement, const OpenPatches& patches, double height) {
  double area = 0;
  for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
    const Triangle t = test::corners_of(arrangement, arrangement.pieces[p]);
    const bool is_there = std::ranges::all_of(t, [&](const Vec3& c) { return c.z() == height; });
    if (is_there && patches.kept[p]) area += normal_of(t[0], t[1], t[2]).norm() / 2;
  }
  return area;
}

}  // namespace

TEST_CASE("a single sheet is one patch, which is kept in either orientation") {
  for (const bool is_reversed : {false, true}) {
    const Mesh mesh = is_reversed ? test::reversed(sheet(1, 0)) : sheet(1, 0);
    const OpenPatches patches = find_exterior_patches(test::arranged_open(mesh, {0, 0}), 1);
    CHECK(patches.patches == 1);
    CHECK(std::ranges::all_of(patches.kept, [](char kept) { return kept != 0; }));
    CHECK(patches.decided_by_number == 0);
  }
}

TEST_CASE("a sheet through a closed box loses what is inside") {
  const Mesh box = test::cuboid(Vec3::Constant(-1), Vec3::Constant(1));
  std::vector<Index> components(box.faces.size() + 2, no_index);
  components[box.faces.size()] = components[box.faces.size() + 1] = 0;
  const Arrangement arrangement = test::arranged_open(test::joined(box, sheet(2, .25)), components);
  const OpenPatches patches = find_exterior_patches(arrangement, 1);
  CHECK(kept_area(arrangement, patches, .25) == doctest::Approx(16 - 4));
  CHECK(patches.patches >= 2);
}

TEST_CASE("two sheets that do not meet both stay, in any orientation") {
  for (const bool is_reversed : {false, true}) {
    const Mesh upper = is_reversed ? test::reversed(sheet(1, 1)) : sheet(1, 1);
    const Arrangement arrangement =
        test::arranged_open(test::joined(sheet(1, 0), upper), {0, 0, 1, 1});
    const OpenPatches patches = find_exterior_patches(arrangement, 1);
    CHECK(kept_area(arrangement, patches, 0) == doctest::Approx(4));
    CHECK(kept_area(arrangement, patches, 1) == doctest::Approx(4));
  }
}

TEST_CASE("of two intersecting sheets the half in front of the other stays") {
  for (const bool is_reversed : {false, true}) {
    CAPTURE(is_reversed);
    Mesh upright = test::reversed(sheet(1, 0));
    for (Vec3& p : upright.positions) p = {p.z(), p.y(), p.x()};  // faces +x
    if (is_reversed) upright = test::reversed(upright);
    const Arrangement arrangement =
        test::arranged_open(test::joined(sheet(1, 0), upright), {0, 0, 1, 1});
    const OpenPatches patches = find_exterior_patches(arrangement, 1);
    CHECK(patches.patches == 4);
    CHECK(patches.decided_by_number == 0);
    double area = 0;
    for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
      const Triangle t = test::corners_of(arrangement, arrangement.pieces[p]);
      const Vec3 middle = (t[0] + t[1] + t[2]) / 3;
      const bool is_flat = t[0].z() == 0 && t[1].z() == 0 && t[2].z() == 0;
      const bool is_in_front = is_flat ? (middle.x() > 0) != is_reversed : middle.z() > 0;
      CHECK((patches.kept[p] != 0) == is_in_front);
      if (patches.kept[p]) area += normal_of(t[0], t[1], t[2]).norm() / 2;
    }
    CHECK(area == doctest::Approx(4));
  }
}
