#include "shapes/kinds.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "helpers/shape_options.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("kinds have names of their own, known options, and make a mesh from their defaults") {
  const std::set<std::string> known{"radius", "tube", "gap", "neck", "count"};
  std::set<std::string> names;
  for (const shapes::Kind& kind : shapes::kinds()) {
    CAPTURE(kind.name);
    CHECK(names.insert(kind.name).second);
    for (const std::string& option : kind.options) CHECK(known.contains(option));
    ShapeOptions options = shape(kind.name);
    options.parameters = kind.parameters;
    if (kind.name == "hull") options.points = make_sphere(Vec3::Zero(), 1, 1500).positions;
    CHECK(kind.make(options, 1500, {}).faces.size() > 500);
  }
}

TEST_CASE("lengths are accepted if their fourth power is finite") {
  CHECK(shapes::is_sensible_length(1e-50));
  CHECK(shapes::is_sensible_length(1e50));
  CHECK_FALSE(shapes::is_sensible_length(0.9e-50));
  CHECK_FALSE(shapes::is_sensible_length(1.1e50));
  CHECK_FALSE(shapes::is_sensible_length(0));
  CHECK_FALSE(shapes::is_sensible_length(-1));
}

TEST_CASE("parameters that are no whole numbers, no lengths or out of range are refused") {
  const auto refused = [](const std::string& kind, std::vector<std::string> parameters) {
    const auto& all = shapes::kinds();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const shapes::Kind& k) { return k.name == kind; });
    REQUIRE(found != all.end());
    CHECK_THROWS_AS(found->make(shape(kind, 0, std::move(parameters)), 1000, {}), UsageError);
  };
  refused("genus", {"0"});
  refused("genus", {"1.5"});
  refused("genus", {"two"});
  refused("torus-knot", {"2", "4"});
  refused("torus-knot", {"2", "x"});
  refused("ellipsoid", {"1", "2%", "3"});
  refused("ellipsoid", {"1", "2", "0"});
  refused("figure", {"1.1"});
  refused("folded", {"cube"});
}

TEST_CASE("a sphere around a box contains it, faces included") {
  ShapeOptions options = shape("sphere");
  options.around = Box{Vec3(1, 2, 3), Vec3(2, 4, 4)};
  const Vec3 middle(1.5, 3, 3.5);
  const double reach = diagonal_of(*options.around) / 2;
  const Mesh mesh = shapes::kinds()[0].make(options, 80, {});
  REQUIRE(shapes::kinds()[0].name == "sphere");
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3& p = mesh.positions[a];
    const Vec3 normal = (mesh.positions[b] - p).cross(mesh.positions[c] - p).normalized();
    CHECK(normal.dot(p - middle) > reach);
    CHECK((p - middle).norm() < 1.35 * reach);
  }
}
