#include "clean/intersect/zones.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "clean/intersect/contacts.h"
#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"

// The oracle is the exact test of two faces.
namespace transformesh {
namespace {

/// How many faces have a zone; in none of them two faces meet, and inside no point is a seam.
std::size_t count_in_zones(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const Zones zones = find_zones(welded);
  std::vector<Index> zone_at(welded.points.size(), no_index);
  std::size_t count = 0, meetings = 0;
  for (Index f = 0; f < welded.faces.size(); ++f) {
    const Index zone = zones.of_face[f];
    for (const Index point : welded.faces[f]) {
      if (zones.is_seam[point]) continue;
      REQUIRE(zone != no_index);
      CHECK((zone_at[point] == no_index || zone_at[point] == zone));
      zone_at[point] = zone;
    }
    if (zone == no_index) continue;
    ++count;
    for (Index g = 0; g < f; ++g)
      meetings += zones.of_face[g] == zone && find_contacts(welded, f, g).meet ? 1 : 0;
  }
  CHECK(meetings == 0);
  return count;
}

/// A strip of two triangles a step that climbs around the axis, with a border on both sides.
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

TEST_CASE("a smooth surface consists of few zones") {
  const Mesh sphere = test::icosphere(3);
  CHECK(count_in_zones(sphere) > sphere.faces.size() * 9 / 10);
  const WeldedMesh welded = weld(sphere);
  std::vector<Index> zones = find_zones(welded).of_face;
  std::sort(zones.begin(), zones.end());
  CHECK(std::unique(zones.begin(), zones.end()) - zones.begin() < 60);
}

TEST_CASE("what lies over itself is no zone, though all of it looks one way") {
  CHECK(count_in_zones(stairs(1, 0.2)) == 48);
  CHECK(count_in_zones(stairs(2, 0.2)) == 0);
}

TEST_CASE("whatever the surface, faces of a zone do not meet") {
  std::size_t in_zones = 0, faces = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    test::Random random(seed);
    for (const double noise : {0.02, 0.1, 0.4}) {
      Mesh mesh = test::icosphere(2);
      for (Vec3& p : mesh.positions) p += random.point(-noise, noise);
      in_zones += count_in_zones(mesh);
      faces += mesh.faces.size();
    }
    Mesh lattice = test::icosphere(1);
    for (Vec3& p : lattice.positions)
      p = Vec3(static_cast<double>(random.below(4)), static_cast<double>(random.below(4)),
               static_cast<double>(random.below(4)));
    count_in_zones(lattice);
  }
  for (const char* kind : {"two-spheres", "folded", "tangle", "boxes", "pinch"})
    count_in_zones(test::workload(kind, 800));
  CHECK(in_zones > faces / 4);
  CHECK(in_zones < faces);
}

}  // namespace
}  // namespace transformesh
