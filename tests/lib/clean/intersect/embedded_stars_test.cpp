#include "clean/intersect/embedded_stars.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clean/intersect/contacts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"

// The oracle is the exact test of two faces.
using namespace transformesh;

namespace {

/// Returns the number of marked stars. Checks that no two faces of a marked star intersect.
std::size_t count_embedded(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const std::vector<char> is_embedded = find_embedded_stars(welded);
  for (Index f = 0; f < welded.faces.size(); ++f)
    for (Index g = 0; g < f; ++g) {
      const Face& other = welded.faces[g];
      const bool is_safe =
          std::any_of(welded.faces[f].begin(), welded.faces[f].end(), [&](Index point) {
            return is_embedded[point] &&
                   std::find(other.begin(), other.end(), point) != other.end();
          });
      if (is_safe) CHECK(!find_contacts(welded, f, g).meet);
    }
  return static_cast<std::size_t>(std::count(is_embedded.begin(), is_embedded.end(), 1));
}

/// A closed star around the origin. Its outer corners go around the axis `turns` times at random
/// heights; another star below closes it.
Mesh star(Index corners, int turns, std::uint64_t seed) {
  test::Random random(seed);
  Mesh mesh{{Vec3::Zero(), Vec3(0, 0, -5)}, {}, {}, {}};
  for (Index i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / corners + random.uniform(0, 0.2);
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), random.uniform(-0.3, 0.3));
  }
  for (Index i = 0; i < corners; ++i) {
    const Index a = 2 + i, b = 2 + (i + 1) % corners;
    mesh.faces.push_back({0, a, b});
    mesh.faces.push_back({1, b, a});
  }
  return mesh;
}

bool is_first_embedded(const Mesh& mesh) { return find_embedded_stars(weld(mesh))[0] != 0; }

TEST_CASE("all stars of smooth surfaces are embedded") {
  const Mesh sphere = test::icosphere(3);
  CHECK(count_embedded(sphere) == sphere.positions.size());
}

TEST_CASE("a star that goes around once is embedded, for either orientation") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Mesh mesh = star(9, 1, seed);
    CHECK(is_first_embedded(mesh));
    count_embedded(mesh);
    for (Face& face : mesh.faces) std::swap(face[0], face[1]);
    CHECK(is_first_embedded(mesh));
    for (Vec3& p : mesh.positions) p = Vec3(p[2], p[0], p[1]);
    CHECK(is_first_embedded(mesh));
  }
}

TEST_CASE("a star that goes around twice, or has another beside it, is not embedded") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CHECK(!is_first_embedded(star(9, 2, seed)));
    CHECK(!is_first_embedded(star(11, 3, seed)));
    Mesh two = star(9, 1, seed);
    const Mesh other = star(9, 1, seed + 100);
    const auto first = static_cast<Index>(two.positions.size());
    for (const Vec3& p : other.positions)
      two.positions.push_back(p + Vec3(0, 0, p == Vec3::Zero() ? 0 : 1e-3));
    for (const auto& [a, b, c] : other.faces)
      two.faces.push_back({a + first, b + first, c + first});
    CHECK(!is_first_embedded(two));
    count_embedded(two);
  }
}

TEST_CASE("a star with a border, a fold or a third face at an edge is not accepted") {
  Mesh open = star(9, 1, 1);
  open.faces.erase(open.faces.begin());
  CHECK(!is_first_embedded(open));
  Mesh folded = star(9, 1, 1);
  folded.positions[4] = Vec3(-0.5, 0.1, 2);
  CHECK(!is_first_embedded(folded));
  Mesh third = star(9, 1, 1);
  third.positions.emplace_back(0, 0, 3);
  third.faces.push_back({0, 2, static_cast<Index>(third.positions.size() - 1)});
  CHECK(!is_first_embedded(third));
}

TEST_CASE("whatever the surface, faces of embedded stars do not meet") {
  std::size_t embedded = 0, stars = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    test::Random random(seed);
    for (const double noise : {0.02, 0.1, 0.4}) {
      Mesh mesh = test::icosphere(2);
      for (Vec3& p : mesh.positions) p += random.point(-noise, noise);
      embedded += count_embedded(mesh);
      stars += mesh.positions.size();
    }
    Mesh lattice = test::icosphere(1);
    for (Vec3& p : lattice.positions)
      p = Vec3(static_cast<double>(random.below(4)), static_cast<double>(random.below(4)),
               static_cast<double>(random.below(4)));
    count_embedded(lattice);
  }
  CHECK(embedded > stars / 4);
  CHECK(embedded < stars);
}

}  // namespace
