#include <doctest/doctest.h>

#include <numbers>

#include "geometry/solid_angle_winding.h"
#include "helpers/shapes.h"
#include "helpers/winding_oracle.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

// The topology changes of the paper's Fig. 7, and handles: components, genus and volume of each.
using namespace transformesh;

namespace {

constexpr double pi = std::numbers::pi;

/// A surface of revolution about the x axis, from a profile of (x, radius) between two poles. A
/// negative radius moves the profile through the axis, which turns that part inside out.
Mesh revolved(const std::vector<std::array<double, 2>>& profile, int around) {
  Mesh mesh;
  const std::size_t rings = profile.size() - 2;
  mesh.positions.emplace_back(profile.front()[0], 0, 0);
  for (std::size_t i = 1; i <= rings; ++i) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * pi * (k + 0.31 * static_cast<double>(i % 2)) / around + 0.123;
      mesh.positions.emplace_back(profile[i][0], profile[i][1] * std::cos(angle),
                                  profile[i][1] * std::sin(angle));
    }
  }
  mesh.positions.emplace_back(profile.back()[0], 0, 0);
  const auto vertex = [&](std::size_t ring, int k) {
    return static_cast<Index>(1 + ring * static_cast<std::size_t>(around) +
                              static_cast<std::size_t>(k % around));
  };
  const auto last = static_cast<Index>(mesh.positions.size() - 1);
  for (int k = 0; k < around; ++k) {
    mesh.faces.push_back({0, vertex(0, k + 1), vertex(0, k)});
    for (std::size_t i = 0; i + 1 < rings; ++i) {
      mesh.faces.push_back({vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1)});
      mesh.faces.push_back({vertex(i, k), vertex(i + 1, k + 1), vertex(i + 1, k)});
    }
    mesh.faces.push_back({last, vertex(rings - 1, k), vertex(rings - 1, k + 1)});
  }
  return mesh;
}

/// Two balls of radius 1 around x = -1.2 and 1.2 with a neck between them.
Mesh dumbbell(double neck) {
  std::vector<std::array<double, 2>> profile{{-2.2, 0}};
  for (int i = 1; i < 40; ++i) {
    const double x = -2.2 + 4.4 * i / 40.0 + 0.003;
    const double ball = std::sqrt(std::max(0.0, 1 - std::pow(std::abs(x) - 1.2, 2)));
    const double blend = std::exp(-12 * x * x);
    profile.push_back({x, ball * (1 - blend) + neck * blend});
  }
  profile.push_back({2.2, 0});
  return revolved(profile, 24);
}

/// A tube with caps, bent around the z axis by an angle that may exceed a full turn, so that its
/// ends intersect.
Mesh bent_tube(double turns, double minor) {
  std::vector<std::array<double, 2>> profile{{0, 0}};
  for (int i = 0; i <= 48; ++i) profile.push_back({i / 48.0, minor});
  profile.push_back({1, 0});
  Mesh mesh = revolved(profile, 16);
  for (Vec3& p : mesh.positions) {
    const double angle = 2 * pi * turns * p[0];
    p = Vec3((1 + p[1]) * std::cos(angle), (1 + p[1]) * std::sin(angle), p[2]);
  }
  return test::reversed(mesh);
}

long total_genus(const Mesh& mesh) {
  long genus = 0;
  for (const Component& component : connected_components(mesh).components) {
    genus += component.genus();
  }
  return genus;
}

struct Expected {
  std::size_t components;
  long genus;
  double volume;
  double tolerance;
};

// Checks all promises of clean(), with both methods.
Mesh check_clean(const Mesh& input, const Expected& expected) {
  CleanOptions by_rays;
  by_rays.method = ExteriorMethod::static_test;
  const CleanResult result = clean(input);
  const Mesh tested = clean(input, by_rays).mesh;
  CHECK(result.mesh.faces == tested.faces);
  CHECK(result.mesh.positions == tested.positions);
  const ManifoldReport report = check_manifold(result.mesh);
  CHECK(report.is_manifold());
  CHECK(report.is_oriented());
  CHECK(report.is_closed());
  CHECK(find_intersections(result.mesh).empty());
  CHECK(connected_components(result.mesh).components.size() == expected.components);
  CHECK(total_genus(result.mesh) == expected.genus);
  CHECK(volume(result.mesh) == doctest::Approx(expected.volume).epsilon(expected.tolerance));
  const auto oracle = test::compare_windings(input, result.mesh);
  INFO(test::describe(oracle));
  CHECK(oracle.is_right());
  return result.mesh;
}

/// Returns the volume with winding number >= 1, by counting points of a grid.
double volume_by_counting(const Mesh& mesh) {
  constexpr int cells = 32;
  const Box box = bounding_box(mesh);
  const Vec3 cell = (box.max() - box.min()) / cells;
  const SolidAngleWinding winding(mesh);
  int inside = 0;
  for (int i = 0; i < cells * cells * cells; ++i) {
    const Vec3 at(i % cells + 0.5, i / cells % cells + 0.5, i / cells / cells + 0.5);
    inside += winding(box.min() + cell.cwiseProduct(at)).number > 0.5 ? 1 : 0;
  }
  return inside * cell.prod();
}

const double ball = volume(test::icosphere(3));

}  // namespace

TEST_CASE("merge: two overlapping balls become one, of the volume of the union") {
  // Unit balls whose centers are d apart share pi (4 + d) (2 - d)^2 / 12.
  const double d = 1.1;
  const Mesh input =
      test::joined(test::icosphere(4), test::moved(test::icosphere(4), {d, .13, .07}));
  const double distance = Vec3(d, .13, .07).norm();
  const double lens = pi * (4 + distance) * std::pow(2 - distance, 2) / 12;
  check_clean(input, {1, 0, 8 * pi / 3 - lens, 0.01});
}

TEST_CASE("split: a neck pushed through itself leaves two balls") {
  const Mesh connected = dumbbell(0.3);
  CHECK(find_intersections(connected).empty());
  CHECK(connected_components(connected).components.size() == 1);
  const Mesh input = dumbbell(-0.3);
  CHECK(volume(input) > 0);
  const Mesh result = check_clean(input, {2, 0, 7.5, 0.1});
  for (const Component& component : connected_components(result).components) {
    CHECK(component.volume > 2.5);
  }
}

TEST_CASE("hole formation: a shell that closes over itself encloses a cavity") {
  // Two bowls, each more than half of a spherical shell, overlap along their rims.
  const auto bowl = [](double tilt) {
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i <= 20; ++i) profile.push_back({std::cos(i * 0.09), std::sin(i * 0.09)});
    for (int i = 20; i >= 0; --i) {
      profile.push_back({0.8 * std::cos(i * 0.09), 0.8 * std::sin(i * 0.09)});
    }
    Mesh mesh = revolved(profile, 20);
    for (Vec3& p : mesh.positions) {
      p = Vec3(p[0] * std::cos(tilt) - p[1] * std::sin(tilt),
               p[0] * std::sin(tilt) + p[1] * std::cos(tilt), p[2]);
    }
    return volume(mesh) < 0 ? test::reversed(mesh) : mesh;
  };
  const Mesh input = test::joined(bowl(0.05), bowl(pi + 0.11));
  const double shell = 4 * pi / 3 * (1 - 0.8 * 0.8 * 0.8);
  const Mesh result = check_clean(input, {2, 0, shell, 0.05});
  double cavity = 0;
  for (const Component& component : connected_components(result).components) {
    cavity = std::min(cavity, component.volume);
  }
  CHECK(cavity == doctest::Approx(-4 * pi / 3 * 0.512).epsilon(0.05));

  CleanOptions outermost;
  outermost.outermost = true;
  const CleanResult skin = clean(input, outermost);
  CHECK(skin.dropped_components == 1);
  CHECK(volume(skin.mesh) == doctest::Approx(4 * pi / 3).epsilon(0.05));
}

TEST_CASE("hole loss: a cavity that turns inside out is gone") {
  const Mesh cavity = test::reversed(test::scaled(test::icosphere(2), 0.5));
  const Mesh everted = test::scaled(cavity, -1);
  const Mesh hollow = test::joined(test::icosphere(3), cavity);
  CHECK(clean(hollow).changed == false);
  CHECK(connected_components(hollow).components.size() == 2);
  check_clean(test::joined(test::icosphere(3), everted), {1, 0, ball, 1e-12});
}

TEST_CASE("handle creation: a tube bent onto itself becomes a ring") {
  const double ring = 2 * pi * pi * 0.3 * 0.3;
  const Mesh open = bent_tube(0.9, 0.3);
  CHECK(find_intersections(open).empty());
  CHECK(total_genus(open) == 0);
  check_clean(bent_tube(1.07, 0.3), {1, 1, ring, 0.05});
}

TEST_CASE("handle removal: a ring whose top is pushed through its bottom somewhere opens there") {
  const Mesh ring = test::torus(1, 0.3, 61, 17);
  const auto narrowed = [&](double by) {
    Mesh mesh = ring;
    for (Vec3& p : mesh.positions) {
      const Vec3 middle = Vec3(p[0], p[1], 0).normalized();
      const double away = std::acos(std::clamp(-middle[0], -1.0, 1.0));
      p[2] *= 1 - by * std::exp(-10 * away * away);
    }
    return mesh;
  };
  CHECK(clean(narrowed(0.5)).changed == false);
  CHECK(total_genus(narrowed(0.5)) == 1);
  const Mesh input = narrowed(1.6);
  check_clean(input, {1, 0, volume_by_counting(input), 0.02});
}

TEST_CASE("an everted ball has nothing inside") {
  CHECK_THROWS_AS(clean(test::reversed(test::icosphere(2))), GoalError);
}
