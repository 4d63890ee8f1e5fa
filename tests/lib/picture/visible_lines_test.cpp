#include "picture/visible_lines.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

const Camera front = orbit_camera({Vec3::Zero(), 8}, {0, 0, Axis::y, 1}, 100, 80);

Mesh random_soup(Random& random, int faces) {
  Mesh soup;
  for (int f = 0; f < faces; ++f) {
    const Vec3 center = random.point(-3, 3);
    const auto base = static_cast<Index>(3 * f);
    for (int i = 0; i < 3; ++i) soup.positions.push_back(center + random.point(-1, 1));
    soup.faces.push_back({base, base + 1, base + 2});
  }
  return soup;
}

/// Returns whether a face lies between the eye and the point, by a ray. `margin` is the distance
/// from the opposite answer, in fractions of faces and of the distance.
bool is_hidden(const Mesh& mesh, const Vec3& eye, const Vec3& point, double& margin) {
  bool hidden = false;
  margin = HUGE_VAL;
  for (const Face& face : mesh.faces) {
    const Vec3& c = mesh.positions[face[2]];
    Eigen::Matrix3d system;
    system << mesh.positions[face[0]] - c, mesh.positions[face[1]] - c, eye - point;
    const Vec3 solution = system.fullPivLu().solve(eye - c);
    const double least = std::min(
        {solution[0], solution[1], 1 - solution[0] - solution[1], solution[2], 1 - solution[2]});
    margin = std::min(margin, std::abs(least));
    hidden = hidden || least > 0;
  }
  return hidden;
}

bool is_in(const VisibleLines::Parts& parts, double place) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const auto& part) { return part.first < place && place < part.second; });
}

}  // namespace

TEST_CASE("visible parts of lines are those that rays from the eye reach") {
  Random random(21);
  int compared = 0;
  int hidden = 0;
  for (int round = 0; round < 10; ++round) {
    const Mesh soup = random_soup(random, 30);
    const VisibleLines lines(soup, front);
    for (int line = 0; line < 10; ++line) {
      const Vec3 from = random.point(-1.5, 1.5);
      const Vec3 to = random.point(-1.5, 1.5);
      const VisibleLines::Parts parts = lines.parts(from, to);
      for (double place = 0.005; place < 1; place += 0.01) {
        double margin = 0;
        const bool expected = is_hidden(soup, front.center(), from + place * (to - from), margin);
        if (margin < 1e-4) continue;
        ++compared;
        hidden += expected;
        REQUIRE(is_in(parts, place) == !expected);
      }
    }
  }
  CHECK(compared > 9000);
  CHECK(hidden > 1000);
  CHECK(hidden < 8000);
}

TEST_CASE("parts end at the borders of the image and in front of the eye") {
  const VisibleLines lines(Mesh{}, front);
  const VisibleLines::Parts across = lines.parts({-100, 0, 0}, {100, 0, 0});
  REQUIRE(across.size() == 1);
  for (const double place : {across[0].first, across[0].second}) {
    const Vec3 q = front.project({-100 + 200 * place, 0, 0});
    CHECK(std::abs(std::abs(q.x() / q.z() - 49.5) - 50) < 1e-9);
  }
  CHECK(lines.parts({0, 0, 9}, {0, 0, 20}).empty());
  const VisibleLines::Parts behind = lines.parts({0, 0, 0}, {0.1, 0, 20});
  REQUIRE(behind.size() == 1);
  CHECK(behind[0].second < 0.4);
  CHECK(lines.parts({5, 0, 0}, {5, 1, 0}).empty());
  CHECK(lines.parts({1e300, 0, 0}, {-1e300, 1e300, 0}).size() <= 1);
}

TEST_CASE("a line on a surface is visible, and one just behind it is not") {
  Mesh sheet = moved(scaled(grid(4), 2), {-1, -1, 0});
  const VisibleLines lines(sheet, front);
  CHECK(lines.parts({-0.9, -0.7, 0}, {0.8, 0.9, 0}) == VisibleLines::Parts{{0, 1}});
  CHECK(lines.parts({-0.9, -0.7, -0.001}, {0.8, 0.9, -0.001}).empty());
  // Faces that extend behind the eye hide the points below them.
  Mesh floor;
  floor.positions = {{-50, -0.1, -50}, {50, -0.1, -50}, {0, -0.1, 100}};
  floor.faces = {{0, 1, 2}};
  const VisibleLines above(floor, front);
  CHECK(above.parts({-1, 0, 0}, {1, 0, 0}).size() == 1);
  CHECK(above.parts({-1, -0.5, 0}, {1, -0.5, 0}).empty());
}

TEST_CASE("a line's own faces do not hide it") {
  const Mesh cube = cuboid({-1, -1, -1}, {1, 1, 1});
  const VisibleLines lines(cube, front);
  std::vector<Index> all(cube.faces.size());
  for (Index f = 0; f < all.size(); ++f) all[f] = f;
  CHECK(lines.parts({-0.5, 0, -1}, {0.5, 0, -1}).empty());
  CHECK(lines.parts({-0.5, 0, -1}, {0.5, 0, -1}, all).size() == 1);
}
