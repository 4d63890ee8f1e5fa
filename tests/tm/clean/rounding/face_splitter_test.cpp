#include "tm/clean/rounding/face_splitter.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "helpers/random.h"

using namespace transformesh;
using doctest::Approx;

namespace {

constexpr double distance = 1e-9;
constexpr std::size_t on_each_edge = 2;
constexpr std::size_t inside = 6;

/// A triangle askew in space, points on its edges and inside, and the triangles made of them.
struct Split {
  std::vector<Vec3> points;
  std::vector<Face> faces;
};

double area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

Vec3 random_inside(test::Random& random, const Triangle& t) {
  const Vec3 weights = random.point(0.1, 1);
  return (weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2]) / weights.sum();
}

Split random_split(test::Random& random, bool has_constraint) {
  Split split;
  for (int i = 0; i < 3; ++i) split.points.push_back(random.point(-1, 1));
  const Triangle triangle{split.points[0], split.points[1], split.points[2]};
  FaceSplitter splitter(triangle, {0, 1, 2}, distance);
  for (std::size_t edge = 0; edge < 3; ++edge)
    for (std::size_t i = 0; i < on_each_edge; ++i) {
      const double share = static_cast<double>(i + 1) / (on_each_edge + 1);
      splitter.add_on_edge(edge, share, static_cast<Index>(split.points.size()));
      const Vec3 &from = triangle[edge], &to = triangle[(edge + 1) % 3];
      split.points.emplace_back(from + share * (to - from));
    }
  for (std::size_t i = 0; i < inside; ++i) {
    const Vec3 point = random_inside(random, triangle);
    splitter.add_inside(point, static_cast<Index>(split.points.size()));
    split.points.push_back(point);
  }
  // From the first edge to the second, past what is inside.
  if (has_constraint) splitter.constrain(3, 3 + on_each_edge);
  splitter.improve();
  split.faces = splitter.triangles();
  return split;
}

std::map<std::array<Index, 2>, int> halfedges_of(const Split& split) {
  std::map<std::array<Index, 2>, int> halfedges;
  for (const Face& f : split.faces)
    for (std::size_t i = 0; i < 3; ++i) ++halfedges[{f[i], f[(i + 1) % 3]}];
  return halfedges;
}

}  // namespace

TEST_CASE("the triangles cover the face once and meet its neighbors along every piece of edge") {
  test::Random random(5);
  for (int round = 0; round < 50; ++round) {
    CAPTURE(round);
    const Split split = random_split(random, round % 2 == 0);
    CHECK(split.faces.size() == 1 + 3 * on_each_edge + 2 * inside);

    double sum = 0;
    for (const auto& [a, b, c] : split.faces)
      sum += area(split.points[a], split.points[b], split.points[c]);
    CHECK(sum == Approx(area(split.points[0], split.points[1], split.points[2])).epsilon(1e-12));

    const auto halfedges = halfedges_of(split);
    std::size_t free_ones = 0;
    for (const auto& [ends, count] : halfedges) {
      CHECK(count == 1);
      free_ones += halfedges.contains({ends[1], ends[0]}) ? 0 : 1;
    }
    CHECK(free_ones == 3 * (on_each_edge + 1));
    for (Index edge = 0; edge < 3; ++edge) {
      const auto first = static_cast<Index>(3 + edge * on_each_edge);
      CHECK(halfedges.contains({edge, first}));
      CHECK(halfedges.contains({first, first + 1}));
      CHECK(halfedges.contains({first + 1, (edge + 1) % 3}));
    }
  }
}

TEST_CASE("a constrained segment becomes an edge and stays one") {
  test::Random random(6);
  int without = 0;
  for (int round = 0; round < 50; ++round) {
    const std::uint64_t seed = 100 + static_cast<std::uint64_t>(round);
    const auto is_edge = [&](bool has_constraint) {
      test::Random same(seed);
      const auto halfedges = halfedges_of(random_split(same, has_constraint));
      const Index to = 3 + on_each_edge;
      return halfedges.contains({3, to}) || halfedges.contains({to, 3});
    };
    CHECK(is_edge(true));
    without += is_edge(false) ? 1 : 0;
  }
  CHECK(without < 50);
}

TEST_CASE("two sheets of a film end in the same triangles") {
  // Corners of a square within another face, which see each other along either diagonal alike.
  const Triangle below{Vec3(-2, -2, 0), Vec3(4, -2, 0), Vec3(-2, 4, 0)};
  const Triangle above{Vec3(-3, -2, 0), Vec3(-3, 6, 0), Vec3(5, -2, 0)};
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto diagonals = [&](const Triangle& triangle, const Face& ids) {
    FaceSplitter splitter(triangle, ids, distance);
    for (Index i = 0; i < 4; ++i) splitter.add_inside(square[i], i);
    for (Index i = 0; i < 4; ++i) splitter.constrain(i, (i + 1) % 4);
    splitter.improve();
    std::array<bool, 2> found{};
    for (const Face& f : splitter.triangles())
      for (std::size_t i = 0; i < 3; ++i)
        for (Index k = 0; k < 2; ++k)
          found[k] = found[k] || std::minmax({f[i], f[(i + 1) % 3]}) == std::pair(k, k + 2);
    return found;
  };
  CHECK(diagonals(below, {4, 5, 6}) == std::array{true, false});
  CHECK(diagonals(above, {7, 8, 9}) == std::array{true, false});
}
