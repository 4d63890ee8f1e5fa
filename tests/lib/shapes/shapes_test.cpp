#include "transformesh/shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

constexpr double pi = std::numbers::pi;

void check_sound(const Mesh& mesh) {
  const Count counted = count(mesh);
  CHECK(counted.is_closed_and_oriented);
  CHECK(counted.is_manifold);
  CHECK_FALSE(counted.has_isolated_vertices);
  CHECK(mesh.vertex_columns.columns.empty());
  CHECK(mesh.face_columns.columns.empty());
}

}  // namespace

TEST_CASE("every kind is closed, oriented, manifold and near the faces wanted, for any seed") {
  for (const std::string& kind : kinds_without_hull())
    // Legs and arms of the figure take more faces than the others.
    for (const std::size_t faces : {kind == "figure" ? 1000 : 500, 6000})
      for (const std::uint64_t seed : {1, 2, 3}) {
        CAPTURE(kind);
        CAPTURE(faces);
        CAPTURE(seed);
        ShapeOptions options = shape(kind, faces);
        options.seed = seed;
        const Mesh mesh = make_shape(options);
        check_sound(mesh);
        CHECK(signed_volume(mesh) > 0);
        CHECK(static_cast<double>(mesh.faces.size()) ==
              doctest::Approx(static_cast<double>(faces)).epsilon(0.06));
      }
}

TEST_CASE("genus and components are those of the kind") {
  using Genera = std::vector<long>;
  const auto genera = [](const ShapeOptions& options) { return count(make_shape(options)).genera; };
  CHECK(genera(shape("sphere")) == Genera{0});
  CHECK(genera(shape("dented")) == Genera{0});
  CHECK(genera(shape("ellipsoid")) == Genera{0});
  CHECK(genera(shape("box")) == Genera{0});
  CHECK(genera(shape("torus")) == Genera{1});
  CHECK(genera(shape("torus-knot")) == Genera{1});
  CHECK(genera(shape("torus-knot", 4000, {"3", "7"})) == Genera{1});
  CHECK(genera(shape("two-spheres")) == Genera{0, 0});
  CHECK(genera(shape("tori")) == Genera{1, 1});
  CHECK(genera(shape("dumbbell")) == Genera{0});
  CHECK(genera(with_neck(shape("dumbbell"), -0.15)) == Genera{0});
  CHECK(genera(shape("bowl")) == Genera{0});
  CHECK(genera(shape("figure")) == Genera{0});
  CHECK(genera(shape("folded")) == Genera{0});
  CHECK(genera(shape("folded", 4000, {"torus"})) == Genera{1});
  CHECK(genera(shape("tangle")) == Genera{1});
  CHECK(genera(shape("many-spheres")) == Genera(40, 0));
  CHECK(genera(shape("boxes")) == Genera(50, 0));
  CHECK(genera(shape("pinch")) == Genera{0});
  for (const long holes : {1, 2, 3, 4, 5, 7}) {
    CAPTURE(holes);
    CHECK(genera(shape("genus", 5000, {std::to_string(holes)})) == Genera{holes});
  }
}

TEST_CASE("volumes are those of the smooth shapes, up to the flatness of faces") {
  // The fraction of volume that inscribed faces lack is inversely proportional to their number.
  const auto check = [](ShapeOptions options, double volume) {
    CAPTURE(options.kind);
    options.faces = 3000;
    const double coarse = 1 - signed_volume(make_shape(options)) / volume;
    options.faces = 12000;
    const double fine = 1 - signed_volume(make_shape(options)) / volume;
    CHECK(coarse > 0);
    CHECK(coarse < 0.03);
    CHECK(coarse / fine == doctest::Approx(4).epsilon(0.08));
  };
  ShapeOptions sphere = shape("sphere");
  sphere.radius = 0.8;
  check(sphere, 4 * pi / 3 * std::pow(0.8, 3));
  check(shape("ellipsoid", 0, {"1", "0.8", "0.5"}), 4 * pi / 3 * 0.4);
  ShapeOptions torus = shape("torus");
  torus.radius = 1;
  torus.tube = 0.4;
  check(torus, 2 * pi * pi * 0.16);
  check(with_gap(shape("two-spheres"), 0.1), 8 * pi / 3 * std::pow(0.7, 3));
  check(with_gap(shape("tori"), 0.08), 4 * pi * pi * 0.62 * 0.27 * 0.27);

  // A shell of inner radius 0.63 and outer radius 1.17 up to 9 degrees above the horizon, and half
  // a disk swept along its rim (Pappus).
  const double angle = 0.05 * pi;
  const double shell = 2 * pi / 3 * (1 + std::sin(angle)) * (std::pow(1.17, 3) - std::pow(0.63, 3));
  const double centroid = 0.9 * std::cos(angle) - 4 * 0.27 / (3 * pi) * std::sin(angle);
  check(shape("bowl"), shell + 2 * pi * centroid * pi * 0.27 * 0.27 / 2);
}

TEST_CASE("a tube around a knot has the volume of its cross section times its length") {
  ShapeOptions options = shape("torus-knot", 40000, {"2", "5"});
  options.radius = 1;
  options.tube = 0.1;
  double length = 0;
  Vec3 last(1.42, 0, 0);
  constexpr int steps = 100000;
  for (int i = 1; i <= steps; ++i) {
    const double t = 2 * pi * i / steps;
    const double radius = 1 + 0.42 * std::cos(5 * t);
    const Vec3 here(radius * std::cos(2 * t), radius * std::sin(2 * t), 0.42 * std::sin(5 * t));
    length += (here - last).norm();
    last = here;
  }
  CHECK(signed_volume(make_shape(options)) == doctest::Approx(pi * 0.01 * length).epsilon(0.01));
}

TEST_CASE("a box has its exact volume, and its corners where they belong") {
  const Mesh mesh = make_shape(shape("box", 3000, {"2", "1", "0.5"}));
  CHECK(signed_volume(mesh) == doctest::Approx(1).epsilon(1e-12));
  const Box box = bounding_box(mesh);
  CHECK(box.min() == Vec3(-1, -0.5, -0.25));
  CHECK(box.max() == Vec3(1, 0.5, 0.25));
  CHECK(make_shape(shape("box", 1)).faces.size() == 12);
}

TEST_CASE("triangles are well shaped") {
  for (const char* kind : {"sphere", "dented", "ellipsoid", "torus", "genus", "torus-knot",
                           "two-spheres", "tori", "dumbbell", "bowl", "figure"}) {
    CAPTURE(kind);
    CHECK(mean_smallest_angle(make_shape(shape(kind))) > 49);
  }
}

TEST_CASE("edges are as long as asked for") {
  for (const char* kind : {"sphere", "box", "torus", "genus", "torus-knot", "two-spheres", "tori",
                           "dumbbell", "bowl", "figure", "tangle"}) {
    CAPTURE(kind);
    ShapeOptions options = shape(kind);
    options.edge = 0.05;
    CHECK(mean_edge(make_shape(options)) == doctest::Approx(0.05).epsilon(0.03));
  }
}

TEST_CASE("center moves, and around contains with little room") {
  ShapeOptions options = shape("sphere", 320);
  options.center = {5, -3, 2};
  CHECK((bounding_box(make_shape(options)).min() - Vec3(4, -4, 1)).norm() < 0.1);

  options = shape("sphere", 20);
  options.around = Box(Vec3(1, 2, 3), Vec3(2, 4, 6));
  for (const std::size_t faces : {20, 320, 5000}) {
    options.faces = faces;
    const Mesh mesh = make_shape(options);
    double nearest = 1e300;
    for (const double x : {1, 2})
      for (const double y : {2, 4})
        for (const double z : {3, 6}) {
          CHECK(winding_number(mesh, {x, y, z}) == doctest::Approx(1));
          for (const Vec3& point : mesh.positions)
            nearest = std::min(nearest, (point - Vec3(x, y, z)).norm());
        }
    if (faces == 5000) CHECK(nearest < 0.1 * std::sqrt(14));
  }
}

TEST_CASE("noise moves along the normals, by its amplitude at most, and depends on the seed") {
  ShapeOptions options = shape("sphere", 5000);
  options.noise = 0.05;
  const Mesh first = make_shape(options);
  options.seed = 2;
  const Mesh second = make_shape(options);
  CHECK(first.positions != second.positions);
  double largest = 0;
  for (const Vec3& point : first.positions) largest = std::max(largest, std::abs(point.norm() - 1));
  CHECK(largest > 0.02);
  CHECK(largest < 0.051);
  CHECK(crossings(first).pairs == 0);
}

TEST_CASE("the same options give the same bytes for any number of threads") {
  for (const std::string& kind : kinds_without_hull()) {
    CAPTURE(kind);
    const auto made = [&](int threads) {
      const ThreadLimit limit(threads);
      ShapeOptions options = shape(kind, 3000);
      options.noise = 0.1;
      return make_shape(options);
    };
    const Mesh one = made(1);
    const Mesh four = made(4);
    CHECK(one.positions == four.positions);
    CHECK(one.faces == four.faces);
  }
}

TEST_CASE("senseless options are refused") {
  const auto refused = [](const ShapeOptions& options) {
    CHECK_THROWS_AS(make_shape(options), UsageError);
  };
  refused(shape("shpere"));
  refused(shape("sphere", 0, {"3"}));
  refused(shape("torus-knot", 0, {"2", "4"}));
  refused(shape("torus-knot", 0, {"2"}));
  refused(shape("torus-knot", 0, {"2", "-3"}));
  refused(shape("genus", 0, {"0"}));
  refused(shape("genus", 0, {"3x"}));
  refused(shape("genus", 100, {"3"}));
  refused(shape("box", 0, {"1", "0", "1"}));
  refused(shape("ellipsoid", 0, {"1", "1", "10%"}));
  refused(shape("folded", 0, {"cube"}));
  refused(with_neck(shape("sphere"), 0.1));
  refused(with_neck(shape("dumbbell"), 0));
  refused(with_neck(shape("dumbbell"), 0.8));
  refused(with_gap(shape("two-spheres"), -1.4));
  refused(with_gap(shape("tori"), 1));
  for (const double radius : {0.0, -1.0}) {
    ShapeOptions options = shape("sphere");
    options.radius = radius;
    refused(options);
  }
  ShapeOptions options = shape("torus");
  options.tube = 1;
  refused(options);
  options = shape("sphere", 100);
  options.edge = 0.1;
  refused(options);
  options.faces.reset();
  options.edge = 1e-9;
  refused(options);
  options = shape("boxes");
  options.edge = 1;
  refused(options);
  options = shape("torus");
  options.around = Box(Vec3::Zero(), Vec3::Ones());
  refused(options);
  refused(shape("sphere", 2000000000));
}

TEST_CASE("making a shape can be cancelled") {
  const Progress stop([](std::string_view, double) { return false; });
  CHECK_THROWS_AS(make_shape(shape("genus"), stop), CancelledError);
}

TEST_CASE("a dented sphere has its dents where they belong, and is a sphere elsewhere") {
  const Mesh mesh = make_shape(shape("dented", 20000));
  double least = 10;
  double most = 0;
  Vec3 deepest = Vec3::Zero();
  for (const Vec3& position : mesh.positions) {
    most = std::max(most, position.norm());
    if (position.norm() >= least) continue;
    least = position.norm();
    deepest = position.normalized();
  }
  CHECK(most < 1.1);
  CHECK(least > 0.6);
  CHECK(least < 0.8);
  CHECK((deepest - Vec3(0.8, 0.5, 0.33).normalized()).norm() < 0.1);
}
