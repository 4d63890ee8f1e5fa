#include "remesh/guards/triangle_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/intersect.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Returns the exact answer, from the search of tm-intersect.
bool do_meet(const Triangle& first, const Triangle& second) {
  Mesh mesh;
  mesh.positions.insert(mesh.positions.end(), first.begin(), first.end());
  mesh.positions.insert(mesh.positions.end(), second.begin(), second.end());
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  return !find_intersections(mesh).empty();
}

bool has_area(const Triangle& triangle) {
  return !(triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).isZero(1e-9);
}

struct Counts {
  int apart = 0;
  int certainly_apart = 0;
  int missed = 0;  ///< contacts that were not found
};

/// Random pairs with `common` common corners, on a lattice unless `cells` is 0.
Counts compare(std::size_t common, std::uint64_t cells, int rounds) {
  Random random(common + 10 * cells);
  const auto point = [&] {
    if (cells == 0) return random.point(-1, 1);
    const auto x = static_cast<double>(random.below(cells));
    const auto y = static_cast<double>(random.below(cells));
    return Vec3(x, y, static_cast<double>(random.below(cells)));
  };
  Counts counts;
  for (int round = 0; round < rounds; ++round) {
    const Triangle first{point(), point(), point()};
    Triangle second{point(), point(), point()};
    for (std::size_t i = 0; i < common; ++i) second[i] = first[(i + 1) % 3];
    if (!has_area(first) || !has_area(second)) continue;
    const bool meets = do_meet(first, second);
    const bool may = may_touch(first, second);
    counts.apart += !meets;
    counts.certainly_apart += !may;
    counts.missed += meets && !may;
  }
  return counts;
}

}  // namespace

TEST_CASE("no contact is missed, and triangles apart in general position are found to be apart") {
  for (const std::size_t common : {0, 1, 2}) {
    const Counts counts = compare(common, 0, 2000);
    CAPTURE(common);
    CHECK(counts.missed == 0);
    CHECK(counts.certainly_apart >= counts.apart - 2);  // nearly folded pairs count as contact
    CHECK(counts.apart > 500);
  }
}

TEST_CASE("no contact is missed on a lattice, where most pairs are degenerate") {
  for (const std::size_t common : {0, 1, 2}) {
    const Counts counts = compare(common, 4, 4000);
    CAPTURE(common);
    CHECK(counts.missed == 0);
    CHECK(counts.certainly_apart > 9 * counts.apart / 10);
    CHECK(counts.apart > 500);
  }
}

TEST_CASE("neighbors in a plane are apart, folded ones are not") {
  const Triangle left{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  CHECK_FALSE(may_touch(left, {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}));
  CHECK_FALSE(may_touch(left, {Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 1, 0)}));
  CHECK_FALSE(may_touch(left, {Vec3(0, 0, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)}));
  CHECK(may_touch(left, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.1, 0.1, 0)}));
  CHECK(may_touch(left, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.1, 0.1, 1e-9)}));
  CHECK(may_touch(left, left));
}

TEST_CASE("a gap below rounding is contact, one above is not") {
  const Triangle floor{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const auto above = [](double z) {
    return Triangle{Vec3(0.2, 0.2, z), Vec3(1, 1, 1), Vec3(0, 1, 1)};
  };
  CHECK(may_touch(floor, above(0)));
  CHECK(may_touch(floor, above(1e-13)));
  CHECK_FALSE(may_touch(floor, above(1e-10)));
}

TEST_CASE("a triangle with two corners in one place may touch any that has a corner there") {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(-1, 0, 1), e(0, -1, 1);
  for (std::size_t turn = 0; turn < 3; ++turn) {
    Triangle thin{a, a, b};
    std::rotate(thin.begin(), thin.begin() + static_cast<std::ptrdiff_t>(turn), thin.end());
    for (const Triangle& other :
         {Triangle{a, d, e}, Triangle{d, a, e}, Triangle{d, e, a}, Triangle{a, b, c}, thin}) {
      CHECK(may_touch(thin, other));
      CHECK(may_touch(other, thin));
    }
    CHECK_FALSE(may_touch(thin, {Vec3(5, 5, 5), Vec3(6, 5, 5), Vec3(5, 6, 5)}));
  }
  CHECK(may_touch({a, a, a}, {a, b, c}));
}

TEST_CASE("triangles at one corner are tested like all pairs of them") {
  Random random(11);
  int meeting = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<Triangle> star;
    for (int i = 0; i < 60; ++i) {
      const auto rim = [&](int k) {
        const double angle = 0.1 * k;
        return Vec3(std::cos(angle), std::sin(angle), 0.1);
      };
      star.push_back({Vec3::Zero(), rim(i), rim(i + 1)});
    }
    // A small triangle at the same corner, inside or beside one of the others.
    const double angle = random.uniform(0, 6);
    const Vec3 inside(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.05);
    star.push_back({Vec3::Zero(), inside + Vec3(0, 0, random.uniform(-0.1, 0.1)),
                    inside + Vec3(0, 0, random.uniform(-0.1, 0.1))});
    bool expected = false;
    for (std::size_t i = 0; i < star.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) expected = expected || may_touch(star[i], star[j]);
    CHECK(meet_each_other(star) == expected);
    meeting += expected;
  }
  CHECK(meeting > 10);
  CHECK(meeting < 30);
}
