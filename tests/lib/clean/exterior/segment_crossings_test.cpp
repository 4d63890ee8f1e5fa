// Intersections of random segments in a triangle, compared with a test of all pairs.
#include "clean/exterior/segment_crossings.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/random.h"

using namespace transformesh;

namespace {

/// Segments in the triangle with corners (0, 0), (10, 0) and (0, 10).
struct Segments {
  std::vector<Vec3> positions{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
  std::vector<Face> faces{{0, 1, 2}};
  ExactGeometry geometry{positions, faces};
  SegmentsInFace in;

  Segments() {
    in.face = 0;
    in.projection = {0, 1};
  }
  void add(const Vec3& from, const Vec3& to, int jump = 1) {
    const auto first = static_cast<Index>(in.points.size());
    for (const Vec3& point : {from, to}) {
      in.points.push_back(ExactGeometry::free(point));
      in.edge_of.push_back(no_index);
    }
    in.segments.push_back({first, first + 1, 0, jump});
  }
  const Vec3& from(Index s) const { return in.points[in.segments[s].from].center; }
  const Vec3& to(Index s) const { return in.points[in.segments[s].to].center; }
};

double turn(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).z(); }

bool do_cross(const Segments& all, Index s, Index t) {
  return turn(all.from(s), all.to(s), all.from(t)) * turn(all.from(s), all.to(s), all.to(t)) < 0 &&
         turn(all.from(t), all.to(t), all.from(s)) * turn(all.from(t), all.to(t), all.to(s)) < 0;
}

/// Returns the parameter along s of its intersection with t.
double share(const Segments& all, Index s, Index t) {
  const double from = turn(all.from(t), all.to(t), all.from(s));
  const double to = turn(all.from(t), all.to(t), all.to(s));
  return from / (from - to);
}

}  // namespace

TEST_CASE("segment crossings agree with testing all pairs, in order along each segment") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    test::Random random(seed);
    Segments all;
    for (int i = 0; i < 40; ++i)
      all.add({random.uniform(.1, 5), random.uniform(.1, 4.9), 0},
              {random.uniform(.1, 5), random.uniform(.1, 4.9), 0}, i % 2 == 0 ? 1 : -1);
    SegmentCrossings crossings(all.geometry, all.in);
    REQUIRE(crossings.find());
    for (Index s = 0; s < all.in.segments.size(); ++s) {
      REQUIRE(crossings.sort_along(s));
      std::vector<Index> expected;
      for (Index t = 0; t < all.in.segments.size(); ++t)
        if (t != s && do_cross(all, s, t)) expected.push_back(t);
      std::ranges::sort(expected, {}, [&](Index t) { return share(all, s, t); });
      std::vector<Index> found;
      for (const Crossing& crossing : crossings.of(s)) {
        found.push_back(crossing.other);
        CHECK(crossing.segment == s);
        CHECK(crossing.least <= share(all, s, crossing.other) + 1e-12);
        CHECK(crossing.most >= share(all, s, crossing.other) - 1e-12);
        const bool starts_left =
            turn(all.from(crossing.other), all.to(crossing.other), all.from(s)) > 0;
        CHECK(crossing.side == (starts_left ? 1 : -1));
        CHECK(crossings.jump_over(crossing) ==
              crossing.side * all.in.segments[crossing.other].jump);
      }
      CHECK(found == expected);
    }
  }
}

TEST_CASE("segments that touch do not merely cross, but those that share an end do") {
  Segments touching;
  touching.add({1, 1, 0}, {3, 1, 0});
  touching.add({2, 1, 0}, {2, 3, 0});
  CHECK(!SegmentCrossings(touching.geometry, touching.in).find());

  Segments apart;
  apart.add({1, 1, 0}, {3, 1, 0});
  apart.add({1, 2, 0}, {3, 2, 0});
  SegmentCrossings none(apart.geometry, apart.in);
  CHECK(none.find());
  CHECK(none.of(0).empty());
}

TEST_CASE("the order of three segments through one point is undecided") {
  Segments all;
  all.add({1, 2, 0}, {3, 2, 0});
  all.add({2, 1, 0}, {2, 3, 0});
  all.add({1, 1, 0}, {3, 3, 0});
  SegmentCrossings crossings(all.geometry, all.in);
  REQUIRE(crossings.find());
  CHECK(!crossings.sort_along(0));
}

TEST_CASE("a segment has a side, and a box around both ends") {
  Segments all;
  all.add({1, 1, 0}, {4, 2, 0});
  SegmentCrossings crossings(all.geometry, all.in);
  CHECK(crossings.find());
  CHECK(crossings.box(0).contains(Eigen::Vector2d(1, 1)));
  CHECK(crossings.box(0).contains(Eigen::Vector2d(4, 2)));
  CHECK(!crossings.box(0).contains(Eigen::Vector2d(1, 2.001)));
}
