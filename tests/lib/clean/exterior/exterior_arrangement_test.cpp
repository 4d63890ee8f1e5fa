/// Exterior pieces of arrange_exterior(), compared with the exterior pieces of the whole
/// arrangement. Winding numbers of the whole arrangement are counted by a ray for each piece.
#include "clean/exterior/exterior_arrangement.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "clean/exterior/exterior.h"
#include "clean/intersect/find_meetings.h"
#include "helpers/arrangement_facts.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

/// A triangle, beginning with its smallest corner, and how often it is covered.
using Facet = std::pair<std::array<std::array<double, 3>, 3>, int>;

Facet facet_of(const Arrangement& arrangement, const Piece& piece) {
  std::array<std::array<double, 3>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 p = arrangement.position(piece.corners[i]);
    corners[i] = {p.x(), p.y(), p.z()};
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return {corners, piece.multiplicity};
}

std::vector<Facet> expected(const Arrangement& arrangement, int winding_level) {
  const std::vector<char> kept = find_exterior_by_rays(arrangement, winding_level, Progress());
  std::vector<Facet> facets;
  for (std::size_t p = 0; p < kept.size(); ++p)
    if (kept[p]) facets.push_back(facet_of(arrangement, arrangement.pieces[p]));
  std::sort(facets.begin(), facets.end());
  return facets;
}

ExteriorArrangement exterior_of(const Mesh& mesh, int winding_level) {
  const auto welded = std::make_shared<const WeldedMesh>(weld(mesh));
  return arrange_exterior(welded, find_meetings(*welded, Progress()),
                          {winding_level, false, nullptr}, Progress());
}

std::vector<Facet> found(const ExteriorArrangement& exterior) {
  std::vector<Facet> facets;
  for (const Piece& piece : exterior.arrangement.pieces)
    facets.push_back(facet_of(exterior.arrangement, piece));
  std::sort(facets.begin(), facets.end());
  return facets;
}

/// Compares all facets, and returns their number.
std::size_t compare(const Mesh& mesh) {
  const Arrangement whole = test::arranged(mesh);
  std::size_t count = 0;
  for (const int winding_level : {-1, 1, 2, 3}) {
    CAPTURE(winding_level);
    const ExteriorArrangement exterior = exterior_of(mesh, winding_level);
    const std::vector<Facet> facets = found(exterior);
    REQUIRE(facets == expected(whole, winding_level));
    CHECK(exterior.whole_faces == whole.whole_pieces);
    count += facets.size();
  }
  return count;
}

Vec3 lattice_point(test::Random& random, std::uint64_t size) {
  const auto x = static_cast<double>(random.below(size));
  const auto y = static_cast<double>(random.below(size));
  return {x, y, static_cast<double>(random.below(size))};
}

/// Boxes on a lattice: faces overlap, are coplanar, or are copies of each other.
Mesh lattice_boxes(std::uint64_t seed, int count, std::uint64_t size) {
  test::Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3 low = lattice_point(random, size);
    const Mesh box = test::cuboid(low, low + Vec3::Ones() + lattice_point(random, 2));
    mesh = test::joined(mesh, random.below(4) == 0 ? test::reversed(box) : box);
  }
  return mesh;
}

/// Tetrahedra on a lattice: edges intersect, touch or overlap others, and corners lie on faces.
Mesh lattice_tetrahedra(std::uint64_t seed, std::size_t count, std::uint64_t size) {
  test::Random random(seed);
  Mesh mesh;
  while (mesh.faces.size() < 4 * count) {
    Mesh tetrahedron = test::tetrahedron();
    for (Vec3& p : tetrahedron.positions) p = lattice_point(random, size);
    const auto& p = tetrahedron.positions;
    if ((p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]) == 0) continue;
    mesh = test::joined(mesh, tetrahedron);
  }
  return mesh;
}

}  // namespace

TEST_CASE("exterior pieces of balls agree with rays") {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    count += compare(test::random_balls(seed, 6));
  }
  CHECK(count > 2000);
}

TEST_CASE("exterior pieces of stacked boxes agree with rays") {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    count += compare(lattice_boxes(seed, 3 + static_cast<int>(seed % 7), 2 + seed % 4));
  }
  CHECK(count > 5000);
}

TEST_CASE("exterior pieces of tetrahedra on a lattice agree with rays") {
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    CAPTURE(seed);
    count += compare(lattice_tetrahedra(seed, 2 + seed % 9, 3 + seed % 3));
  }
  CHECK(count > 5000);
}

TEST_CASE("shapes that share vertices and edges, and copies, are distinguished") {
  const Mesh ball = test::icosphere(1);
  compare(test::joined(ball, ball));
  compare(test::joined(ball, test::reversed(ball)));
  compare(test::joined(test::joined(ball, ball), test::reversed(ball)));
  compare(test::joined(ball, test::scaled(ball, 0.5)));
  // Cubes that share an edge, a corner, a part of a face, or half an edge.
  const Mesh cube = test::cube();
  for (const Vec3& by : {Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(1, 0.5, 0.5), Vec3(1, 1, 0.5),
                         Vec3(1, 0, 0), Vec3(0.5, 0, 0)})
    compare(test::joined(cube, test::moved(cube, by)));
}

TEST_CASE("interior faces are not cut, and there is at most one ray per component") {
  Mesh mesh = test::scaled(test::icosphere(2), 2);
  test::Random random(2);
  for (int i = 0; i < 6; ++i) {
    const Mesh ball = test::scaled(test::icosphere(2), 0.5);
    mesh = test::joined(mesh, test::moved(ball, random.point(-0.3, 0.3)));
  }
  const ExteriorArrangement exterior = exterior_of(mesh, 1);
  CHECK(exterior.arrangement.cut_points.empty());
  CHECK(exterior.arrangement.pieces.size() == test::icosphere(2).faces.size());
  CHECK(exterior.rays == 7);
  CHECK(exterior.whole_faces < mesh.faces.size());
}

TEST_CASE("exterior pieces do not depend on threads") {
  const Mesh mesh = lattice_boxes(4, 30, 6);
  const auto run = [&](int threads) {
    const ThreadLimit limit(threads);
    const ExteriorArrangement exterior = exterior_of(mesh, 1);
    std::vector<Face> faces;
    for (const Piece& piece : exterior.arrangement.pieces) faces.push_back(piece.corners);
    return std::pair(faces, exterior.rays);
  };
  CHECK(run(1) == run(4));
}
