#include "clean/intersect/intersection_free_regions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "clean/intersect/contacts.h"
#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "transformesh/control.h"
#include "transformesh/intersect.h"

// The oracle is the exact test of two faces.
using namespace transformesh;

namespace {

/// Returns the number of faces in regions. Checks that no two faces of a region intersect, and that
/// all faces at a point are in one region unless the point is on a seam.
std::size_t count_in_regions(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const IntersectionFreeRegions regions = find_intersection_free_regions(welded);
  std::vector<Index> region_at(welded.points.size(), no_index);
  std::size_t count = 0, meetings = 0;
  for (Index f = 0; f < welded.faces.size(); ++f) {
    const Index region = regions.of_face[f];
    for (const Index point : welded.faces[f]) {
      if (regions.is_seam[point]) continue;
      REQUIRE(region != no_index);
      CHECK((region_at[point] == no_index || region_at[point] == region));
      region_at[point] = region;
    }
    if (region == no_index) continue;
    ++count;
    for (Index g = 0; g < f; ++g)
      meetings += regions.of_face[g] == region && find_contacts(welded, f, g).meet ? 1 : 0;
  }
  CHECK(meetings == 0);
  return count;
}

/// A strip that spirals upwards around the axis, two triangles per step, with a border on both
/// sides.
Mesh stairs(int turns, double rise) {
  constexpr Index steps = 24;
  Mesh mesh;
  for (Index i = 0; i <= steps * static_cast<Index>(turns); ++i) {
    const double angle = 6.283185307179586 * i / steps, height = rise * i / steps;
    for (const double radius : {1.0, 2.0})
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    if (i == 0) continue;
    const Index a = 2 * i - 2, b = 2 * i - 1, c = 2 * i, d = 2 * i + 1;
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({c, b, d});
  }
  return mesh;
}

TEST_CASE("a smooth surface consists of few regions") {
  const Mesh sphere = test::icosphere(3);
  CHECK(count_in_regions(sphere) > sphere.faces.size() * 9 / 10);
  const WeldedMesh welded = weld(sphere);
  std::vector<Index> regions = find_intersection_free_regions(welded).of_face;
  std::sort(regions.begin(), regions.end());
  CHECK(std::unique(regions.begin(), regions.end()) - regions.begin() < 60);
}

TEST_CASE("a surface that overlaps itself is no region, even if it faces one way") {
  CHECK(count_in_regions(stairs(1, 0.2)) == 48);
  CHECK(count_in_regions(stairs(2, 0.2)) == 0);
}

TEST_CASE("whatever the surface, faces of a region do not meet") {
  std::size_t in_regions = 0, faces = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    test::Random random(seed);
    for (const double noise : {0.02, 0.1, 0.4}) {
      Mesh mesh = test::icosphere(2);
      for (Vec3& p : mesh.positions) p += random.point(-noise, noise);
      in_regions += count_in_regions(mesh);
      faces += mesh.faces.size();
    }
    Mesh lattice = test::icosphere(1);
    for (Vec3& p : lattice.positions)
      p = Vec3(static_cast<double>(random.below(4)), static_cast<double>(random.below(4)),
               static_cast<double>(random.below(4)));
    count_in_regions(lattice);
  }
  for (const char* kind : {"two-spheres", "folded", "tangle", "boxes", "pinch"})
    count_in_regions(test::workload(kind, 800));
  CHECK(in_regions > faces / 4);
  CHECK(in_regions < faces);
}

TEST_CASE("regions of several threads cover as many faces, and the same pairs meet") {
  const Mesh mesh = test::workload("two-spheres", 300'000);
  std::vector<std::vector<FacePair>> pairs;
  for (const int threads : {1, 2, 5}) {
    CAPTURE(threads);
    const ThreadLimit limit(threads);
    const IntersectionFreeRegions regions = find_intersection_free_regions(weld(mesh));
    CHECK(std::count(regions.of_face.begin(), regions.of_face.end(), no_index) < 3000);
    pairs.push_back(find_intersections(mesh));
  }
  CHECK(pairs[0].size() > 1000);
  CHECK(pairs[1] == pairs[0]);
  CHECK(pairs[2] == pairs[0]);
}

TEST_CASE("faces in random order have regions, too, for any number of threads") {
  Mesh mesh = test::workload("two-spheres", 300'000);
  const std::size_t pairs = find_intersections(mesh).size();
  test::Random random(1);
  for (std::size_t f = mesh.faces.size(); f > 1; --f)
    std::swap(mesh.faces[f - 1], mesh.faces[random.below(f)]);
  for (const int threads : {1, 4}) {
    CAPTURE(threads);
    const ThreadLimit limit(threads);
    const IntersectionFreeRegions regions = find_intersection_free_regions(weld(mesh));
    CHECK(std::count(regions.of_face.begin(), regions.of_face.end(), no_index) < 3000);
    CHECK(find_intersections(mesh).size() == pairs);
  }
}

}  // namespace
