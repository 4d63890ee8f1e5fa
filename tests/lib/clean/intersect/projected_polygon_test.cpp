#include "clean/intersect/projected_polygon.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace transformesh;

namespace {

/// Returns whether a closed polygon is simple, seen along z. Checks that views along x and y of the
/// rotated polygon give the same answer.
bool is_simple(const std::vector<Vec3>& corners) {
  std::array<bool, 3> answers{};
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<Vec3> points;
    for (const Vec3& p : corners) {
      Vec3 turned;
      for (int axis = 0; axis < 3; ++axis) turned[(axis + turn) % 3] = p[axis];
      points.push_back(turned);
    }
    ProjectedPolygon outline(points);
    for (Index i = 0; i < points.size(); ++i)
      outline.add(i, static_cast<Index>((i + 1) % points.size()));
    answers[static_cast<std::size_t>(turn)] = outline.is_simple({turn, (turn + 1) % 3});
  }
  CHECK(answers[0] == answers[1]);
  CHECK(answers[0] == answers[2]);
  return answers[0];
}

TEST_CASE("a polygon that does not intersect itself is simple, for any heights") {
  CHECK(is_simple({{0, 0, 0}, {1, 0, 5}, {0, 1, -5}}));
  CHECK(is_simple({{0, 0, 0}, {2, 0, 0}, {1, 1, 9}, {2, 2, 0}, {0, 2, 0}}));
  CHECK(!is_simple({{0, 0, 0}, {2, 2, 1}, {2, 0, 0}, {0, 2, 5}}));
}

TEST_CASE("a corner that touches an edge or a corner is no simple outline") {
  CHECK(!is_simple({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 1}, {0, 4, 0}}));
  CHECK(!is_simple({{0, 0, 0}, {2, 1, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 1}, {0, 4, 0}}));
}

TEST_CASE("collinear edges are apart if they continue, and not if they fold back") {
  CHECK(is_simple({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}}));
  CHECK(!is_simple({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}}));
  CHECK(!is_simple({{0, 0, 0}, {0, 2, 0}, {0, 1, 0}, {1, 1, 0}}));
}

TEST_CASE("a polygon that goes around twice is not simple") {
  std::vector<Vec3> points;
  for (int i = 0; i < 18; ++i) {
    const double angle = 4 * 3.14159265358979 * i / 18;
    points.emplace_back((2 + 0.05 * i) * std::cos(angle), (2 + 0.05 * i) * std::sin(angle), i);
  }
  CHECK(!is_simple(points));
}

TEST_CASE("an outline with very many adjacent edges is rejected, not accepted") {
  std::vector<Vec3> comb;
  for (int i = 0; i < 400; ++i) {
    comb.emplace_back(i % 2 == 0 ? 0 : 1000, i, 0);
    comb.emplace_back(i % 2 == 0 ? 1000 : 0, i, 0);
  }
  comb.emplace_back(0, 400, 0);
  comb.emplace_back(-1, 400, 0);
  comb.emplace_back(-1, 0, 0);
  CHECK(!is_simple(comb));
}

}  // namespace
