#include "geometry/search/float_box.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

}  // namespace

TEST_CASE("rounding outwards gives the tightest floats around a double") {
  test::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double value =
        std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(320)) - 160);
    const float below = float_below(value);
    const float above = float_above(value);
    CHECK(below <= value);
    CHECK(value <= above);
    const bool is_tight = below == above || std::nextafter(below, infinity) == above;
    CHECK(is_tight);
  }
}

TEST_CASE("values that are floats stay as they are") {
  for (const float value : {0.0F, 1.0F, -2.5F, 1e-45F, -1e-45F, largest, -largest, infinity}) {
    CHECK(float_below(value) == value);
    CHECK(float_above(value) == value);
  }
}

TEST_CASE("values beyond the range of floats round to infinity on one side only") {
  CHECK(float_below(1e300) == largest);
  CHECK(float_above(1e300) == infinity);
  CHECK(float_below(-1e39) == -infinity);
  CHECK(float_above(-1e39) == -largest);
  CHECK(float_above(1e-300) == std::numeric_limits<float>::denorm_min());
  CHECK(float_below(1e-300) == 0);
  CHECK(float_below(-1e-300) == -std::numeric_limits<float>::denorm_min());
}

TEST_CASE("face boxes hold their corners, also of a selection of faces") {
  const Mesh mesh = test::scaled(test::icosphere(2), 1.0 / 3);
  const auto boxes = face_boxes(mesh);
  REQUIRE(boxes.size() == mesh.faces.size());
  for (std::size_t f = 0; f < boxes.size(); ++f)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const Index vertex : mesh.faces[f]) {
        low = std::min(low, mesh.positions[vertex][static_cast<Eigen::Index>(axis)]);
        high = std::max(high, mesh.positions[vertex][static_cast<Eigen::Index>(axis)]);
      }
      CHECK(boxes[f].min()[axis] == float_below(low));
      CHECK(boxes[f].max()[axis] == float_above(high));
    }
  const std::vector<Index> some{7, 3, 7};
  const auto selected = face_boxes(mesh, some);
  REQUIRE(selected.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(selected[i].min() == boxes[some[i]].min());
}
TEST_CASE("a point far away does not make boxes indistinguishable") {
  std::vector<Vec3> points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(4e6 + i, 5e6, 1e-3 * i);
  points.emplace_back(1e15, -2e17, 0);
  const BoxFrame frame(points);
  for (std::size_t i = 0; i + 2 < points.size(); ++i)
    CHECK(frame.box(points[i], points[i]).max()[0] <
          frame.box(points[i + 1], points[i + 1]).min()[0]);
}

TEST_CASE("magnitudes that floats do not hold are distinguished, and keep their order") {
  std::vector<Vec3> points;
  for (int i = -150; i <= 150; ++i) {
    const double x = std::pow(10.0, i);
    points.emplace_back(x, -x, i % 2 == 0 ? x : -x);
    points.emplace_back(-x, x, 0);
  }
  const BoxFrame frame(points);
  for (const Vec3& p : points) {
    for (const Vec3& q : points) {
      const FloatBox at_p = frame.box(p, p), at_q = frame.box(q, q);
      for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        CHECK(at_p.min()[i] <= at_p.max()[i]);
        if (p[axis] < q[axis]) CHECK(at_p.max()[i] < at_q.min()[i]);
        if (p[axis] == q[axis]) CHECK(at_p.min()[i] <= at_q.max()[i]);
      }
    }
  }
  // Boxes of rays extend to the largest numbers.
  constexpr double farthest = std::numeric_limits<double>::max();
  const FloatBox all = frame.box(Vec3::Constant(-farthest), Vec3::Constant(farthest));
  for (const Vec3& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(all.min()[i] <= frame.box(p, p).min()[i]);
      CHECK(all.max()[i] >= frame.box(p, p).max()[i]);
    }
}
