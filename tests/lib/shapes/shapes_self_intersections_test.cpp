/// Shapes that intersect themselves, in which way, and shapes that do not.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "transformesh/errors.h"
#include "transformesh/shapes.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("plain kinds do not intersect themselves") {
  std::vector<ShapeOptions> plain;
  for (const std::size_t faces : {500, 6000}) {
    for (const char* kind : {"sphere", "dented", "ellipsoid", "box", "torus", "genus", "torus-knot",
                             "tori", "dumbbell", "bowl"})
      plain.push_back(shape(kind, faces));
    plain.push_back(with_gap(shape("two-spheres", faces), 0.05));
  }
  plain.push_back(shape("torus-knot", 6000, {"3", "5"}));
  plain.push_back(shape("torus-knot", 6000, {"5", "2"}));
  plain.push_back(shape("genus", 6000, {"7"}));
  for (const ShapeOptions& options : plain) {
    CAPTURE(options.kind);
    CAPTURE(*options.faces);
    CHECK(crossings(make_shape(options)).pairs == 0);
  }
}

TEST_CASE("tori whose faces are too few to keep apart are refused") {
  CHECK_THROWS_AS(make_shape(shape("tori", 100)), UsageError);
  CHECK(crossings(make_shape(shape("tori", 200))).pairs == 0);
}

TEST_CASE("workloads intersect themselves, in general position") {
  for (const std::size_t faces : {500, 6000})
    for (const std::uint64_t seed : {1, 2, 3}) {
      std::vector<ShapeOptions> workloads = {shape("two-spheres", faces),
                                             shape("folded", faces),
                                             shape("folded", faces, {"torus"}),
                                             shape("tangle", faces),
                                             shape("many-spheres", faces),
                                             with_gap(shape("tori", faces), -0.1),
                                             with_neck(shape("dumbbell", faces), -0.15)};
      for (ShapeOptions& options : workloads) {
        options.seed = seed;
        CAPTURE(options.kind);
        CAPTURE(faces);
        CAPTURE(seed);
        const Mesh mesh = make_shape(options);
        const Crossings found = crossings(mesh);
        CHECK(found.pairs > 5);
        CHECK(found.flattest > 1e-11 * std::pow(mean_edge(mesh), 3));
      }
    }
}

TEST_CASE("overlaps have winding number 2 and an inverted neck -1") {
  CHECK(winding_number(make_shape(shape("two-spheres")), {0, 0, 0}) == doctest::Approx(2));
  CHECK(winding_number(make_shape(with_gap(shape("tori"), -0.1)), {0, 0, 0}) == doctest::Approx(2));
  const Mesh plain = make_shape(shape("dumbbell"));
  const Mesh inverted = make_shape(with_neck(shape("dumbbell"), -0.15));
  CHECK(winding_number(plain, {0, 0, 0}) == doctest::Approx(1));
  CHECK(winding_number(inverted, {0, 0, 0}) == doctest::Approx(-1));
  CHECK(winding_number(inverted, {0, 0, 0.7}) == doctest::Approx(1));
  CHECK(winding_number(inverted, {0, 0, -0.7}) == doctest::Approx(1));
}

TEST_CASE("boxes are integer, and share planes, edges and whole faces") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    ShapeOptions options = shape("boxes");
    options.seed = seed;
    const Mesh mesh = make_shape(options);
    CHECK(mesh.faces.size() == 600);
    std::map<std::array<double, 3>, std::size_t> corners;
    std::map<std::set<std::array<double, 3>>, std::size_t> edges;
    std::map<std::pair<int, double>, std::set<std::size_t>> planes;
    const auto key = [](const Vec3& p) { return std::array<double, 3>{p.x(), p.y(), p.z()}; };
    for (const Vec3& point : mesh.positions) {
      CHECK(point == Vec3(point.array().round()));
      ++corners[key(point)];
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const Vec3& from = mesh.positions[mesh.faces[f][i]];
        const Vec3& to = mesh.positions[mesh.faces[f][(i + 1) % 3]];
        const Vec3& next = mesh.positions[mesh.faces[f][(i + 2) % 3]];
        ++edges[{key(from), key(to)}];
        for (int axis = 0; axis < 3; ++axis)
          if (from[axis] == to[axis] && to[axis] == next[axis])
            planes[{axis, from[axis]}].insert(f / 12);
      }
    const auto most = [](const auto& table) {
      std::size_t result = 0;
      for (const auto& [entry, times] : table) result = std::max(result, times);
      return result;
    };
    CHECK(most(corners) > 1);  // boxes that meet in a corner
    CHECK(most(edges) > 2);    // boxes that meet in an edge
    std::size_t coplanar = 0;
    for (const auto& [plane, boxes] : planes) coplanar = std::max(coplanar, boxes.size());
    CHECK(coplanar > 5);
  }
}

TEST_CASE("a pinch has hundreds of edges through exactly one point") {
  const Mesh mesh = make_shape(shape("pinch"));
  std::set<std::pair<Index, Index>> through;
  for (const Face& face : mesh.faces)
    for (int i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      if (mesh.positions[a] == -mesh.positions[b]) through.insert(std::minmax(a, b));
    }
  CHECK(through.size() > 200);
  CHECK(crossings(make_shape(shape("pinch", 2000))).pairs > 1000);
}
