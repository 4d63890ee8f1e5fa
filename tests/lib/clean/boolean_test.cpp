// Boolean operations by cleaning, compared with CGAL's corefinement, with other orders of operands,
// with sampled volumes and with counted voxels.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <numeric>
#include <optional>

#include "helpers/cgal_boolean.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "helpers/winding_oracle.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

/// Rotates the mesh at random, then shifts it by up to `shift` along each axis.
Mesh placed(Mesh mesh, test::Random& random, double shift) {
  const Vec3 axis = random.point(-1, 1).normalized();
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(random.uniform(0, 3), axis).toRotationMatrix();
  const Vec3 by = random.point(-shift, shift);
  for (Vec3& p : mesh.positions) p = rotation * p + by;
  return mesh;
}

/// Returns nothing if no point has that winding number.
std::optional<Mesh> cleaned(const Mesh& mesh, int winding_level = 1) {
  CleanOptions options;
  options.winding_level = winding_level;
  try {
    return clean(mesh, options).mesh;
  } catch (const GoalError&) {
    return std::nullopt;
  }
}

void check_same_body(const std::optional<Mesh>& own, const Mesh& expected, double size) {
  CHECK(own.has_value() == !expected.faces.empty());
  if (!own || expected.faces.empty()) return;
  const test::Count facts = test::count(*own);
  CHECK(facts.is_closed_and_oriented);
  CHECK(facts.is_manifold);
  CHECK(facts.genera == test::count(expected).genera);
  CHECK(std::abs(test::signed_volume(*own) - test::signed_volume(expected)) < 1e-12 * size);
}

/// Returns the exact volume: a sixth of the sum of the determinants of all faces.
boost::multiprecision::cpp_rational exact_volume(const Mesh& mesh) {
  using Rational = boost::multiprecision::cpp_rational;
  Rational sum = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    const auto at = [&](Index v, int axis) { return Rational(mesh.positions[v][axis]); };
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      sum += at(a, i) * (at(b, j) * at(c, k) - at(b, k) * at(c, j));
    }
  }
  return sum / 6;
}

}  // namespace

TEST_CASE("union, intersection and difference agree with CGAL's corefinement") {
  struct Pair {
    ShapeOptions first, second;
    double shift;
  };
  using test::shape;
  const std::vector<Pair> pairs = {
      {shape("sphere", 500), shape("sphere", 700), 0.6},
      {shape("sphere", 300), shape("sphere", 200), 2},
      {shape("torus", 600), shape("torus", 500), 0.5},
      {shape("torus", 600), shape("sphere", 300), 0.8},
      {shape("box", 12), shape("box", 12), 0.4},
      {shape("box", 12), shape("torus", 600), 0.4},
      {shape("ellipsoid", 400), shape("box", 200), 0.5},
      {shape("torus-knot", 2500), shape("sphere", 300), 0.5},
      {shape("torus-knot", 2500), shape("torus-knot", 2000), 0.3},
      {shape("genus", 1500, {"3"}), shape("torus", 500), 0.4},
      {shape("bowl", 1000), shape("dumbbell", 800), 0.4},
      {test::with_gap(shape("tori", 1200), 0.1), shape("bowl", 800), 0.4},
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      CAPTURE(i);
      CAPTURE(seed);
      test::Random random(100 * i + seed);
      const Mesh a = placed(make_shape(pairs[i].first), random, 0);
      const Mesh b = placed(make_shape(pairs[i].second), random, pairs[i].shift);
      const test::Booleans expected = test::cgal_booleans(a, b);
      const double size = test::signed_volume(a) + test::signed_volume(b);
      check_same_body(cleaned(test::joined(a, b)), expected.united, size);
      check_same_body(cleaned(test::joined(a, b), 2), expected.common, size);
      check_same_body(cleaned(test::joined(a, test::reversed(b))), expected.difference, size);
    }
  }
}

TEST_CASE("nested and disjoint bodies agree with CGAL's corefinement") {
  const Mesh ball = make_shape(test::shape("sphere", 500));
  const Mesh small = test::scaled(make_shape(test::shape("torus", 300)), 0.3);
  const Mesh far = test::moved(make_shape(test::shape("box", 12)), {5, 1, 0});
  for (const auto& [a, b] :
       {std::pair(ball, small), std::pair(small, ball), std::pair(ball, far)}) {
    const test::Booleans expected = test::cgal_booleans(a, b);
    check_same_body(cleaned(test::joined(a, b)), expected.united, 10);
    check_same_body(cleaned(test::joined(a, b), 2), expected.common, 10);
    check_same_body(cleaned(test::joined(a, test::reversed(b))), expected.difference, 10);
  }
  CHECK(test::cgal_booleans(small, ball).difference.faces.empty());
  CHECK(test::cgal_booleans(ball, far).common.faces.empty());
}

TEST_CASE("the union is the same in any order, at once and one by one") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Mesh> bodies;
    for (const char* kind : {"sphere", "torus", "box", "torus-knot", "ellipsoid", "bowl"}) {
      bodies.push_back(placed(make_shape(test::shape(kind, 900)), random, 0.7));
    }
    std::vector<std::size_t> order(bodies.size());
    std::iota(order.begin(), order.end(), 0U);
    std::optional<Mesh> first;
    for (int round = 0; round < 4; ++round) {
      Mesh all;
      Mesh one_by_one;
      for (const std::size_t i : order) {
        all = test::joined(all, bodies[i]);
        one_by_one = clean(test::joined(one_by_one, bodies[i])).mesh;
      }
      const Mesh united = clean(all).mesh;
      if (!first) first = united;
      check_same_body(united, *first, test::signed_volume(*first));
      check_same_body(one_by_one, *first, test::signed_volume(*first));
      for (std::size_t i = order.size() - 1; i > 0; --i) {
        std::swap(order[i], order[random.below(i + 1)]);
      }
    }
  }
}

namespace {

/// Returns the interval in which a line along z lies inside a convex polyhedron whose faces are
/// oriented outwards. The plane of each face cuts the line.
std::optional<std::array<double, 2>> interval_inside(const Mesh& convex, double x, double y) {
  double low = -1e300;
  double high = 1e300;
  for (const auto& [a, b, c] : convex.faces) {
    const Vec3& p = convex.positions[a];
    const Vec3 normal = (convex.positions[b] - p).cross(convex.positions[c] - p);
    // inside if rest >= normal.z() * z
    const double rest = normal.dot(p) - normal.x() * x - normal.y() * y;
    if (normal.z() > 0) high = std::min(high, rest / normal.z());
    if (normal.z() < 0) low = std::max(low, rest / normal.z());
    if (normal.z() == 0 && rest < 0) return std::nullopt;
  }
  if (low >= high) return std::nullopt;
  return std::array{low, high};
}

double length_inside_any(const std::vector<Mesh>& bodies, double x, double y) {
  std::vector<std::array<double, 2>> intervals;
  for (const Mesh& body : bodies) {
    if (const auto interval = interval_inside(body, x, y)) intervals.push_back(*interval);
  }
  std::sort(intervals.begin(), intervals.end());
  double length = 0;
  double reached = -1e300;
  for (const auto& [low, high] : intervals) {
    length += std::max(0.0, high - std::max(low, reached));
    reached = std::max(reached, high);
  }
  return length;
}

}  // namespace

TEST_CASE("the volume of overlapping balls agrees with random samples") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Mesh> balls;
    Mesh all;
    for (int i = 0; i < 12; ++i) {
      const double radius = random.uniform(0.3, 0.7);
      balls.push_back(placed(test::scaled(test::icosphere(1), radius), random, 0.8));
      all = test::joined(all, balls.back());
    }
    const double own = test::signed_volume(clean(all).mesh);

    // Samples lines in jittered cells of a grid over [-2, 2]^2. The spread of independent runs
    // estimates the error.
    constexpr int runs = 10;
    constexpr int cells = 120;
    constexpr double cell = 4.0 / cells;
    std::array<double, runs> volumes{};
    for (double& volume : volumes) {
      for (int i = 0; i < cells * cells; ++i) {
        const double x = -2 + (i % cells + random.uniform(0, 1)) * cell;
        const double y = -2 + (i / cells + random.uniform(0, 1)) * cell;
        volume += length_inside_any(balls, x, y) * cell * cell;
      }
    }
    const double mean = std::accumulate(volumes.begin(), volumes.end(), 0.0) / runs;
    double variance = 0;
    for (const double volume : volumes) variance += (volume - mean) * (volume - mean);
    const double error = std::sqrt(variance / (runs * (runs - 1)));
    CHECK(error < 1e-3 * mean);
    CHECK(std::abs(own - mean) < 5 * error);
  }
}

TEST_CASE("boxes with integer corners have exactly the volume of their voxels") {
  constexpr int size = 14;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Mesh mesh;
    std::array<bool, size * size * size> is_inside{};
    for (int box = 0; box < 15; ++box) {
      std::array<int, 3> low{};
      std::array<int, 3> high{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = static_cast<int>(random.below(10));
        high[axis] = low[axis] + 1 + static_cast<int>(random.below(4));
      }
      mesh = test::joined(
          mesh, test::cuboid(Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2])));
      for (int x = low[0]; x < high[0]; ++x)
        for (int y = low[1]; y < high[1]; ++y)
          for (int z = low[2]; z < high[2]; ++z) is_inside.at((x * size + y) * size + z) = true;
    }
    const auto voxels = std::count(is_inside.begin(), is_inside.end(), true);
    const Mesh united = clean(mesh).mesh;
    CHECK(exact_volume(united) == voxels);
    CHECK(test::count(united).is_manifold);
    CHECK(find_intersections(united).empty());
    CHECK(test::compare_windings(mesh, united).is_right());
  }
}
