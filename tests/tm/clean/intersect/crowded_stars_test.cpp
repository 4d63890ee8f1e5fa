/// Faces near vertices of high valence, against a test of all pairs of faces.
#include "tm/clean/intersect/crowded_stars.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "helpers/shapes.h"
#include "tm/clean/intersect/contacts.h"
#include "tm/clean/intersect/embedded_stars.h"
#include "tm/clean/intersect/intersect.h"

namespace transformesh {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A double cone over a rim of random places, some of them in line with the apexes.
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

/// Faces of any size and direction with corners on a coarse grid, where many touch axes and edges.
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

TEST_CASE("around vertices of high valence the search finds what all pairs hold") {
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

TEST_CASE("a double cone has few pairs to test") {
  std::mt19937 random(3);
  constexpr Index rim = 4000;
  const WeldedMesh welded = weld(double_cone(random, rim, 0.1, 0));
  const Links links = find_links(welded.points, welded.faces);
  const CrowdedStars stars(welded, find_embedded_stars(welded),
                           CrowdedStars::crowded_points(welded, links));
  CHECK(stars.has(0));
  CHECK(stars.has(1));
  CHECK(stars.find_pairs({}).size() < 6 * rim);
}

}  // namespace transformesh
