/// Patches, checked by closed-form counts and by solid angles.
#include "clean/exterior/patches.h"

#include <doctest/doctest.h>

#include "helpers/arrangement_facts.h"

using namespace transformesh;

namespace {

std::size_t patch_count(const Mesh& mesh) {
  const Arrangement arrangement = test::arranged(mesh);
  return Patches(arrangement).size();
}

Mesh ball(const Vec3& center) { return test::moved(test::icosphere(2), center); }

}  // namespace

TEST_CASE("every circle in which surfaces cross makes two more patches") {
  CHECK(patch_count(ball({0, 0, 0})) == 1);
  CHECK(patch_count(test::joined(ball({0, 0, 0}), ball({3, 0, 0}))) == 2);
  CHECK(patch_count(test::joined(ball({0, 0, 0}), ball({1.1, 0.02, 0.03}))) == 4);
  // A torus intersects both sides of a plate in two circles each, which divide it into four bands.
  const Mesh plate = test::cuboid({-4, -4, -0.1}, {4, 4, 0.103});
  CHECK(patch_count(test::joined(test::torus(2, 0.5, 24, 12), plate)) == 4 + 1 + 4);
}

TEST_CASE("every piece that counts is in one patch") {
  const Arrangement arrangement = test::arranged(test::random_balls(3, 5));
  const Patches patches(arrangement);
  std::vector<int> seen(arrangement.pieces.size(), 0);
  for (Index patch = 0; patch < patches.size(); ++patch) {
    for (const Index p : patches.pieces[patch]) {
      ++seen[p];
      CHECK(patches.patch_of[p] == patch);
    }
  }
  for (std::size_t p = 0; p < seen.size(); ++p)
    CHECK(seen[p] == (arrangement.pieces[p].multiplicity != 0 ? 1 : 0));
}

TEST_CASE("w in front is constant on a patch") {
  std::size_t tested = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = test::random_balls(seed, 4);
    const Arrangement arrangement = test::arranged(mesh);
    const Patches patches(arrangement);
    std::vector<std::optional<int>> front(patches.size());
    for (Index patch = 0; patch < patches.size(); ++patch) {
      for (const Index p : patches.pieces[patch]) {
        const auto winding =
            test::winding_beside(mesh, test::corners_of(arrangement, arrangement.pieces[p]), 1);
        if (!winding) continue;
        if (front[patch]) REQUIRE(*front[patch] == *winding);
        front[patch] = winding;
        ++tested;
      }
    }
  }
  CHECK(tested > 1000);
}

TEST_CASE("pieces that cancel out separate no patches") {
  const Mesh second = test::cuboid({1, 0, 0}, {2, 1, 1});
  // The wall between two adjacent cubes cancels out, and the rest is one surface.
  const Arrangement united = test::arranged(test::joined(test::cube(), second));
  const Patches patches(united);
  CHECK(patches.size() == 1);
  CHECK(std::count(patches.patch_of.begin(), patches.patch_of.end(), no_index) ==
        static_cast<std::ptrdiff_t>(united.pieces.size() - patches.pieces[0].size()));
  CHECK(united.pieces.size() > patches.pieces[0].size());
  // If the second cube is inside out, the wall has multiplicity 2 and is a patch of its own.
  CHECK(patch_count(test::joined(test::cube(), test::reversed(second))) == 3);
}
