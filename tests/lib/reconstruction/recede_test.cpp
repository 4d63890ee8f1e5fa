#include "reconstruction/recede.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "helpers/shapes.h"

using namespace transformesh;

namespace {

constexpr double distance = 0.1;

/// Returns how far the vertices of a unit sphere move inwards. `excess` is that of a single window
/// at each vertex, negative if there is none.
std::vector<double> depths(const std::function<double(const Vec3&)>& excess) {
  Mesh mesh = test::icosphere(4);
  std::vector<WindowSums> sums;
  for (const Vec3& p : mesh.positions)
    sums.push_back(excess(p) < 0 ? WindowSums() : WindowSums{1, excess(p), 0});
  const std::vector<Vec3> before = mesh.positions;
  move_contradicted_inwards(mesh, sums, distance);
  std::vector<double> result;
  for (std::size_t v = 0; v < before.size(); ++v)
    result.push_back((before[v] - mesh.positions[v]).dot(before[v]));
  return result;
}

}  // namespace

TEST_CASE("vertices move inwards by how much photographs disagree") {
  for (const auto& [excess, share] :
       {std::pair(0.0, 0.0), {0.4, 0.0}, {0.6, 0.5}, {0.8, 1.0}, {1.0, 1.0}})
    for (const double depth : depths([value = excess](const Vec3&) { return value; }))
      CHECK(depth == doctest::Approx(distance * share).epsilon(1e-3));
}

TEST_CASE(
    "nothing moves if no two views observe the surface, or photographs confirm all the rest") {
  for (const double depth : depths([](const Vec3&) { return -1.0; })) CHECK(depth == 0);
  for (const double depth : depths([](const Vec3& p) { return p.z() < 0 ? -1.0 : 0.1; }))
    CHECK(depth == 0);
}

TEST_CASE("unobserved vertices move as the contradicted area around them does") {
  // Zones of a unit sphere have areas in proportion to their heights.
  for (const double height : {0.25, 0.5, 0.8}) {
    const std::vector<double> moved = depths([&](const Vec3& p) {
      if (p.z() < -0.4) return -1.0;
      return p.z() < -0.4 + height ? 1.0 : 0.0;
    });
    const Mesh mesh = test::icosphere(4);
    for (std::size_t v = 0; v < moved.size(); ++v) {
      const double z = mesh.positions[v].z();
      const double share = std::min(1.0, height / 0.6);
      // Two rings of vertices blur the zones by up to 0.2.
      if (z < -0.7) CHECK(moved[v] == doctest::Approx(distance * share).epsilon(0.35));
      if (z > -0.4 + height + 0.25) CHECK(moved[v] == 0);
    }
  }
}

TEST_CASE("an unobserved part whose surroundings are confirmed stays while another part moves") {
  const std::vector<double> moved = depths([](const Vec3& p) {
    if (p.z() < -0.8) return -1.0;
    return p.z() > 0.5 ? 1.0 : 0.0;
  });
  const Mesh mesh = test::icosphere(4);
  for (std::size_t v = 0; v < moved.size(); ++v) {
    if (mesh.positions[v].z() < 0) CHECK(moved[v] == 0);
    if (mesh.positions[v].z() > 0.8) CHECK(moved[v] == doctest::Approx(distance).epsilon(1e-3));
  }
}
