/// Orientation of shuffled faces, by volumes and sums along edges that are known.
#include "tm/clean/stitch/orient.h"

#include <doctest/doctest.h>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "tm/clean/stitch/orientation_check.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

/// With every face reversed or not, by a throw of the dice.
Mesh shuffled(Mesh mesh, std::uint64_t seed) {
  test::Random random(seed);
  for (Face& face : mesh.faces) {
    if (random.below(2) == 1) std::swap(face[0], face[1]);
  }
  return mesh;
}

/// How many faces of two meshes with the same faces are oriented differently.
std::size_t differences(const Mesh& first, const Mesh& second) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < first.faces.size(); ++f) {
    Face face = second.faces[f];
    const auto start = std::find(face.begin(), face.end(), first.faces[f][0]);
    std::rotate(face.begin(), start, face.end());
    count += face == first.faces[f] ? 0 : 1;
  }
  return count;
}

}  // namespace

TEST_CASE("closed parts look outwards again, whatever was reversed, and the count is right") {
  const Mesh two =
      test::joined(test::icosphere(2), test::moved(test::torus(2, 0.5, 20, 10), {9, 0, 0}));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const Mesh before = shuffled(two, seed);
    Mesh mesh = before;
    const std::size_t reversed = orient_faces(mesh);
    CHECK(differences(mesh, two) == 0);
    CHECK(reversed == differences(before, two));
    CHECK(mesh.positions == two.positions);
    CHECK(orient_faces(mesh) == 0);
  }
}

TEST_CASE("a part that agreed is left alone, inside out or not") {
  Mesh inside_out = test::reversed(test::icosphere(1));
  CHECK(orient_faces(inside_out) == 0);
  // Beside one that does not agree.
  Mesh mesh = test::joined(inside_out, shuffled(test::moved(test::cube(), {5, 0, 0}), 3));
  orient_faces(mesh);
  CHECK(test::signed_volume(mesh) ==
        doctest::Approx(1 + test::signed_volume(inside_out)).epsilon(1e-12));
}

TEST_CASE("an open part looks the way most of its faces did") {
  for (const int wrong : {1, 40, 60, 127}) {
    CAPTURE(wrong);
    Mesh mesh = test::grid(8);
    const Mesh up = mesh;
    for (int f = 0; f < wrong; ++f) {
      Face& face = mesh.faces[static_cast<std::size_t>(f * 37 % 128)];
      std::swap(face[0], face[1]);
    }
    CHECK(orient_faces(mesh) == static_cast<std::size_t>(std::min(wrong, 128 - wrong)));
    CHECK(differences(mesh, up) == (wrong < 64 ? 0 : 128));
  }
}

TEST_CASE("solids that share an edge, or a wall that is given once, get their insides back") {
  // Two cubes that share the edge from (1, 1, 0) to (1, 1, 1) by their vertices.
  Mesh cubes = test::cube();
  std::array<Index, 8> index{};
  const Mesh second = test::moved(test::cube(), {1, 1, 0});
  for (std::size_t v = 0; v < 8; ++v) {
    const auto found =
        std::find(cubes.positions.begin(), cubes.positions.begin() + 8, second.positions[v]);
    index.at(v) = found != cubes.positions.begin() + 8
                      ? static_cast<Index>(found - cubes.positions.begin())
                      : static_cast<Index>(cubes.positions.size());
    if (index.at(v) >= 8) cubes.positions.push_back(second.positions[v]);
  }
  CHECK(cubes.positions.size() == 14);
  for (const auto& [a, b, c] : second.faces)
    cubes.faces.push_back({index.at(a), index.at(b), index.at(c)});
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    Mesh mesh = shuffled(cubes, seed);
    orient_faces(mesh);
    CHECK(test::signed_volume(mesh) == doctest::Approx(2));
    CHECK(describe_misorientation(mesh).empty());
  }
}

TEST_CASE("a surface with one side is refused with its place") {
  Mesh strip = test::moebius_strip(9);
  const std::vector<Face> before = strip.faces;
  CHECK_THROWS_WITH_AS(orient_faces(strip),
                       doctest::Contains("cannot agree at the edge from vertex"), InputError);
  CHECK(strip.faces == before);
}

}  // namespace transformesh
