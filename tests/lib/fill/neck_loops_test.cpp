/// Loops around necks, compared with the circumferences of surfaces of revolution.
#include "fill/neck_loops.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "helpers/shapes.h"
#include "mesh/adjacency.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// A closed surface around the z axis with the radius `radius(z)` at heights from 0 to `height`.
Mesh revolved(const std::function<double(double)>& radius, double height, Index rings) {
  constexpr Index around = 16;
  Mesh mesh;
  for (Index i = 0; i < rings; ++i)
    for (Index k = 0; k < around; ++k) {
      const double z = height * (i + 0.5) / rings;
      const double angle = 2 * std::numbers::pi * (k + 0.5 * (i % 2)) / around;
      mesh.positions.emplace_back(radius(z) * std::cos(angle), radius(z) * std::sin(angle), z);
    }
  const auto low = static_cast<Index>(mesh.positions.size());
  mesh.positions.emplace_back(0, 0, 0);
  mesh.positions.emplace_back(0, 0, height);
  for (Index k = 0; k < around; ++k) {
    const Index next = (k + 1) % around;
    for (Index i = 0; i + 1 < rings; ++i) {
      const Index a = i * around + k, b = i * around + next;
      const bool is_odd = i % 2 == 1;
      mesh.faces.push_back({a, b, is_odd ? b + around : a + around});
      mesh.faces.push_back({is_odd ? a : b, b + around, a + around});
    }
    mesh.faces.push_back({low, next, k});
    const Index top = (rings - 1) * around;
    mesh.faces.push_back({low + 1, top + k, top + next});
  }
  return mesh;
}

double dumbbell(double z) { return 0.1 + 0.9 * std::abs(std::sin(z)); }

std::vector<NeckLoop> necks_of(const Mesh& mesh, double length) {
  const HalfedgeStars stars(mesh, opposite_halfedges(mesh));
  const NeckTest test(mesh, stars);
  std::vector<NeckLoop> loops = narrow_loops(mesh, stars, length);
  std::erase_if(loops, [&](const NeckLoop& loop) { return !test.is_neck(loop); });
  return loops;
}

/// Returns the circumference of a ring of the mesh, which is a polygon.
double around(double radius) { return 32 * radius * std::sin(std::numbers::pi / 16); }

}  // namespace

TEST_CASE("the neck between two balls is found where it is narrowest, if it is short enough") {
  // Ring 30 of rings 0 to 60 lies at the waist, z = pi.
  const Mesh mesh = revolved(dumbbell, 2 * std::numbers::pi, 61);
  const double waist = around(0.1);
  const std::vector<NeckLoop> necks = necks_of(mesh, 1.05 * waist);
  REQUIRE_FALSE(necks.empty());
  CHECK(necks.front().length == doctest::Approx(waist).epsilon(0.01));
  for (const Index v : necks.front().vertices)
    CHECK(mesh.positions[v].z() == doctest::Approx(std::numbers::pi).epsilon(0.02));
  CHECK(necks_of(mesh, 0.95 * waist).empty());
}

TEST_CASE("every loop is a simple loop of edges, of the length that it states") {
  const Mesh mesh = revolved(dumbbell, 2 * std::numbers::pi, 61);
  const HalfedgeStars stars(mesh, opposite_halfedges(mesh));
  const std::vector<NeckLoop> loops = narrow_loops(mesh, stars, 2);
  REQUIRE(loops.size() > 16);
  double last = 0;
  for (const NeckLoop& loop : loops) {
    double length = 0;
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const Index from = loop.vertices[i], to = loop.vertices[(i + 1) % loop.vertices.size()];
      bool is_edge = false;
      stars.visit(from, [&](Index h) { is_edge |= halfedge_target(mesh, h) == to; });
      CHECK(is_edge);
      length += (mesh.positions[to] - mesh.positions[from]).norm();
    }
    CHECK(loop.length == doctest::Approx(length).epsilon(1e-12));
    CHECK(loop.length <= 2);
    CHECK(loop.length >= last);
    last = loop.length;
    std::vector<Index> sorted = loop.vertices;
    std::sort(sorted.begin(), sorted.end());
    CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
  }
}

TEST_CASE("fingers, bumps and cones have no necks, however narrow they are") {
  const auto finger = [](double z) { return z < 1 ? 0.1 + 0.9 * std::sqrt(1 - z * z) : 0.1; };
  CHECK(necks_of(revolved(finger, 4, 120), 0.7).empty());
  const auto rod = [](double) { return 0.1; };
  CHECK(necks_of(revolved(rod, 4, 100), 0.7).empty());
  const auto cone = [](double z) { return 0.02 + 0.2 * z; };
  CHECK(necks_of(revolved(cone, 4, 100), 0.7).empty());
  CHECK(necks_of(icosphere(3), 2).empty());
}

TEST_CASE("cutting a neck makes fingers on both sides") {
  const Mesh mesh = revolved(
      [](double z) { return std::abs(z - 3) < 2 ? 0.1 : 0.1 + std::sin(std::abs(z - 3) - 2); }, 6,
      120);
  const HalfedgeStars stars(mesh, opposite_halfedges(mesh));
  NeckTest test(mesh, stars);
  const std::vector<NeckLoop> loops = narrow_loops(mesh, stars, 0.7);
  REQUIRE(loops.size() > 100);
  const NeckLoop& cut = loops.front();
  const auto is_apart = [&](const NeckLoop& loop) {
    return std::none_of(loop.vertices.begin(), loop.vertices.end(), [&](Index v) {
      return std::find(cut.vertices.begin(), cut.vertices.end(), v) != cut.vertices.end();
    });
  };
  const auto necks = [&] {
    return std::count_if(loops.begin(), loops.end(), [&](const NeckLoop& loop) {
      return is_apart(loop) && test.is_neck(loop);
    });
  };
  CHECK(necks() > 100);
  test.note_cut(cut);
  CHECK(necks() == 0);
}
