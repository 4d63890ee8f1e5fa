#include "geometry/search/simplex_links.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "clean/intersect/contacts.h"
#include "helpers/random.h"

// The oracle is the exact test of two faces, which does not use links.
using namespace transformesh;

namespace {

constexpr Index many = 60;

/// Corner 0 with faces around it. The other corners are random, or random nodes of a lattice of
/// 3 x 3 x 3, so that edges often coincide.
Mesh fan(std::uint64_t seed, double size, bool on_lattice) {
  test::Random random(seed);
  Mesh mesh{{size * random.point(-1, 1)}, {}, {}, {}};
  const auto coordinate = [&] {
    return on_lattice ? static_cast<double>(random.below(3)) - 1 : random.uniform(-1, 1);
  };
  for (Index i = 0; i < 2 * many; ++i) {
    const Vec3 along(coordinate(), coordinate(), coordinate());
    mesh.positions.push_back(on_lattice ? Vec3(size * along) : mesh.positions[0] + size * along);
  }
  if (on_lattice) mesh.positions[0] = Vec3::Zero();
  for (Index i = 0; i < many; ++i) mesh.faces.push_back({0, 2 * i + 1, 2 * i + 2});
  for (Index i = 1; i < many; ++i) mesh.faces.push_back({0, 2 * i, 2 * i + 1});
  return mesh;
}

/// Corners 0 and 1 with faces at their edge, and further faces that close them to tetrahedra.
Mesh book(std::uint64_t seed, double size) {
  test::Random random(seed);
  Mesh mesh{{size * random.point(-1, 1), size * random.point(-1, 1)}, {}, {}, {}};
  for (Index i = 2; i < many; i += 2) {
    mesh.positions.push_back(size * random.point(-1, 1));
    mesh.positions.push_back(size * random.point(-1, 1));
    for (const Face& face : {Face{0, 1, i}, {0, i + 1, 1}, {0, i, i + 1}, {1, i + 1, i}})
      mesh.faces.push_back(face);
  }
  return mesh;
}

/// Coplanar faces that go twice around their common corner.
Mesh flat_fan() {
  Mesh mesh{{Vec3(0.1, 0.2, 0.3)}, {}, {}, {}};
  for (Index i = 0; i < many; ++i) {
    const double angle = 4 * std::numbers::pi * i / many;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.3);
    mesh.faces.push_back({0, i + 1, (i + 1) % many + 1});
  }
  return mesh;
}

/// Returns the number of pairs of faces that the links find to be apart. Checks that no such pair
/// intersects.
std::size_t count_apart(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const SimplexLinks links = find_simplex_links(welded.points, welded.faces);
  std::size_t count = 0;
  for (Index f = 0; f < welded.faces.size(); ++f)
    for (Index g = 0; g < f; ++g) {
      if (!are_apart(links.of(f), links.of(g))) continue;
      CHECK(!find_contacts(welded, f, g).meet);
      ++count;
    }
  return count;
}

std::size_t count_pairs(const Mesh& mesh) {
  return mesh.faces.size() * (mesh.faces.size() - 1) / 2;
}

TEST_CASE("faces that are apart in a link do not meet") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const double size : {1.0, 1e-200, 1e100}) {
      CHECK(count_apart(fan(seed, size, false)) > 0);
      CHECK(count_apart(fan(seed, size, true)) > 0);
      CHECK(count_apart(book(seed, size)) > 0);
    }
  }
  CHECK(count_apart(fan(1, 1e308, false)) < count_pairs(fan(1, 1e308, false)));
}

TEST_CASE("of a fan or a book of faces nearly all pairs are apart") {
  CHECK(count_apart(flat_fan()) > count_pairs(flat_fan()) * 8 / 10);
  Mesh leaves = book(3, 1);
  CHECK(count_apart(leaves) > count_pairs(leaves) * 4 / 10);
}

TEST_CASE("corners with few faces have no links") {
  Mesh mesh = flat_fan();
  mesh.faces.resize(most_uncrowded);
  CHECK(find_simplex_links(mesh.positions, mesh.faces).empty());
  mesh.faces.push_back({0, 1, 3});
  const SimplexLinks links = find_simplex_links(mesh.positions, mesh.faces);
  CHECK(links.boxes.size() == most_uncrowded + 1);
  CHECK(links.of(0) != nullptr);
}

TEST_CASE("faces have in common what all of them have, with boxes around it") {
  const Mesh mesh = flat_fan();
  const SimplexLinks links = find_simplex_links(mesh.positions, mesh.faces);
  const LinkBoxes common = common_links(*links.of(0), *links.of(15));
  CHECK(common[0].link == 0);
  CHECK(common[1].link == no_index);
  CHECK(!are_apart(common, *links.of(0)));
  CHECK(!are_apart(common, *links.of(15)));
  LinkBoxes other = *links.of(0);
  other[0].link = 7;
  CHECK(common_links(other, *links.of(1))[0].link == no_index);
}

}  // namespace
