/// Faces near vertices of high valence, compared with a test of all pairs of faces.
#include "clean/intersect/high_valence_stars.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "clean/intersect/contacts.h"
#include "clean/intersect/embedded_stars.h"
#include "helpers/shapes.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A double cone. `noise` is the largest random change of radius and height at its rim; `lean`
/// shifts the lower apex along x.
Mesh double_cone(std::mt19937& random, Index rim, double noise, double lean) {
  Mesh mesh;
  mesh.positions = {{0, 0, 1}, {lean, 0, -1}};
  for (Index i = 0; i < rim; ++i) {
    const double angle = 2 * std::numbers::pi * i / rim,
                 radius = 1 + uniform(random, -noise, noise);
    mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                uniform(random, -noise, noise));
  }
  for (Index i = 0; i < rim; ++i) {
    const Index here = 2 + i, next = 2 + (i + 1) % rim;
    mesh.faces.push_back({0, here, next});
    mesh.faces.push_back({1, next, here});
  }
  return mesh;
}

/// Adds faces of any size and direction. About half of their corners are on a coarse grid, so that
/// many faces touch axes and edges.
void add_random_faces(Mesh& mesh, std::mt19937& random, int count) {
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<Index>(mesh.positions.size());
    const Vec3 middle(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    const double size = std::exp2(uniform(random, -5, 1));
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3 p = middle + size * Vec3(uniform(random, -1, 1), uniform(random, -1, 1),
                                          uniform(random, -1, 1));
      mesh.positions.emplace_back(random() % 2 == 0 ? p : Vec3((4 * p).array().round() / 4));
    }
    mesh.faces.push_back({first, first + 1, first + 2});
  }
}

std::vector<FacePair> all_pairs(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  std::vector<FacePair> pairs;
  for (Index f = 0; f < welded.faces.size(); ++f)
    for (Index g = f + 1; g < welded.faces.size(); ++g)
      if (find_contacts(welded, f, g).meet)
        pairs.emplace_back(welded.face_of[f], welded.face_of[g]);
  return pairs;
}

}  // namespace

TEST_CASE("the search around vertices of high valence agrees with testing all pairs") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 40; ++trial) {
    CAPTURE(trial);
    const double lean = trial % 3 == 0 ? 0.3 : 0;
    Mesh mesh = double_cone(random, 40 + random() % 60, trial % 2 == 0 ? 0.2 : 0, lean);
    if (trial % 4 == 0)
      mesh = test::joined(mesh, test::moved(double_cone(random, 50, 0.1, 0), {0.2, 0.1, 0.4}));
    add_random_faces(mesh, random, 60);
    CHECK(find_intersections(mesh) == all_pairs(mesh));
  }
}

TEST_CASE("a face may span all faces of a star, from the first to the last one") {
  std::mt19937 random(11);
  const auto at = [](double degrees, double radius, double height) {
    const double angle = degrees * std::numbers::pi / 180;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), height);
  };
  for (int trial = 0; trial < 40; ++trial) {
    CAPTURE(trial);
    // The first face covers 15 degrees, the last one 172, and the others the rest.
    constexpr Index rim = 40;
    Mesh mesh = double_cone(random, rim, 0, 0);
    for (Index i = 1; i < rim; ++i)
      mesh.positions[2 + i] = at(15 + 173.0 * (i - 1) / (rim - 2), 1, 0);
    for (int i = 0; i < 30; ++i) {
      const double from = uniform(random, 9, 15);
      const auto first = static_cast<Index>(mesh.positions.size());
      for (const double angle : {from, uniform(random, 60, 120), uniform(random, 188, from + 180)})
        mesh.positions.push_back(at(angle, uniform(random, 0.2, 1.5), uniform(random, -1, 1)));
      mesh.faces.push_back({first, first + 1, first + 2});
    }
    CHECK(find_intersections(mesh) == all_pairs(mesh));
  }
}

TEST_CASE("a double cone has few pairs to test") {
  std::mt19937 random(3);
  constexpr Index rim = 4000;
  const WeldedMesh welded = weld(double_cone(random, rim, 0.1, 0));
  const SimplexLinks links = find_simplex_links(welded.points, welded.faces);
  const HighValenceStars stars(welded, find_embedded_stars(welded),
                               HighValenceStars::crowded_points(welded, links));
  CHECK(stars.has(0));
  CHECK(stars.has(1));
  CHECK(stars.find_pairs({}).size() < 6 * rim);
}
