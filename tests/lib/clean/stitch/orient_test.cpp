/// Orientation of faces that were reversed at random, checked by known volumes and sums along
/// edges.
#include "clean/stitch/orient.h"

#include <doctest/doctest.h>

#include "clean/stitch/orientation_check.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

/// Reverses each face at random.
Mesh shuffled(Mesh mesh, std::uint64_t seed) {
  test::Random random(seed);
  for (Face& face : mesh.faces) {
    if (random.below(2) == 1) std::swap(face[0], face[1]);
  }
  return mesh;
}

/// Returns the number of faces whose orientation differs between two meshes with the same faces.
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

/// Merges vertices with equal positions into the first one.
Mesh welded(Mesh mesh) {
  for (Face& face : mesh.faces)
    for (Index& v : face)
      v = static_cast<Index>(std::ranges::find(mesh.positions, mesh.positions[v]) -
                             mesh.positions.begin());
  return mesh;
}

/// A row of cubes along the x axis, each with all its faces; neighbors have two coincident faces
/// each.
Mesh row_of_cubes(int count) {
  Mesh row = test::cube();
  for (int i = 1; i < count; ++i)
    row = test::joined(row, test::moved(test::cube(), {static_cast<double>(i), 0, 0}));
  return row;
}

}  // namespace

TEST_CASE("closed parts are oriented outwards again, and reversed faces are counted") {
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

TEST_CASE("a consistent part stays unchanged, even if it is inside out") {
  Mesh inside_out = test::reversed(test::icosphere(1));
  CHECK(orient_faces(inside_out) == 0);
  // The inside-out ball lies beside a cube with inconsistent faces.
  Mesh mesh = test::joined(inside_out, shuffled(test::moved(test::cube(), {5, 0, 0}), 3));
  orient_faces(mesh);
  CHECK(test::signed_volume(mesh) ==
        doctest::Approx(1 + test::signed_volume(inside_out)).epsilon(1e-12));
}

TEST_CASE("an open part takes the orientation of most of its faces") {
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

TEST_CASE("solids that share an edge, or a single wall, get their insides back") {
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

TEST_CASE("bodies that share faces, edges or corners, and their copies, are oriented outwards") {
  const Mesh ring = test::torus(2, 0.5, 12, 8);
  const Mesh cube = test::cube();
  const Mesh apart = test::joined(cube, test::moved(cube, {1, 1, 1}));
  const std::vector<Mesh> families{
      test::joined(cube, cube), test::joined(test::joined(cube, cube), cube),
      test::joined(test::icosphere(2), test::icosphere(2)), test::joined(ring, ring),
      test::joined(test::joined(ring, ring), ring), row_of_cubes(4),
      test::joined(row_of_cubes(3), row_of_cubes(3)),
      test::joined(cube, test::moved(cube, {1, 1, 0})), test::joined(apart, apart),
      // A cube inside of another cube with a common corner, and the same two cubes twice.
      test::joined(cube, test::scaled(cube, 0.5)),
      test::joined(test::joined(cube, test::scaled(cube, 0.5)),
                   test::joined(cube, test::scaled(cube, 0.5)))};
  for (std::size_t i = 0; i < families.size(); ++i) {
    const Mesh truth = welded(families[i]);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(i);
      CAPTURE(seed);
      Mesh mesh = shuffled(truth, seed);
      orient_faces(mesh);
      CHECK(test::signed_volume(mesh) == doctest::Approx(test::signed_volume(truth)));
      CHECK(describe_misorientation(mesh).empty());
    }
  }
}

TEST_CASE("a copy is not reversed against its original because of one wrong face") {
  for (const Mesh& body : {test::cube(), test::icosphere(1), test::torus(2, 0.5, 12, 8)}) {
    const Mesh twice = welded(test::joined(body, body));
    const std::size_t count = body.faces.size();
    for (std::size_t wrong = 0; wrong < count; ++wrong)
      for (const bool is_open : {false, true}) {
        Mesh mesh = twice;
        std::swap(mesh.faces[count + wrong][0], mesh.faces[count + wrong][1]);
        // The copy has a hole beside the wrong face.
        if (is_open) mesh.faces.erase(mesh.faces.begin() + count + (wrong + 1) % count);
        orient_faces(mesh);
        Mesh truth = twice;
        if (is_open) truth.faces.erase(truth.faces.begin() + count + (wrong + 1) % count);
        CHECK(test::signed_volume(mesh) == doctest::Approx(test::signed_volume(truth)));
      }
  }
}

TEST_CASE("a surface with one side is refused with its place") {
  Mesh strip = test::moebius_strip(9);
  const std::vector<Face> before = strip.faces;
  try {
    orient_faces(strip);
    FAIL("a strip with one side is oriented");
  } catch (const InputError& error) {
    CHECK(std::string(error.what())
              .find("cannot have consistent orientations at the edge from vertex") !=
          std::string::npos);
    CHECK(error.kind() == ErrorKind::one_sided);
    CHECK(error.data().faces.size() == 2);
    const auto [source, target] = error.data().edge.value();
    const Face& face = strip.faces[error.data().faces[0]];
    CHECK(std::ranges::count(face, source) == 1);
    CHECK(std::ranges::count(face, target) == 1);
  }
  CHECK(strip.faces == before);
}
