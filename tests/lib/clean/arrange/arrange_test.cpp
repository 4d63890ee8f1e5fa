/// Arrangements of random triangles on a lattice, which touch, intersect in points, overlap in
/// planes and coincide. The oracle finds vertices and incidences by brute force in rationals.
#include "clean/arrange/arrange.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <set>

#include "clean/intersect/find_meetings.h"
#include "helpers/random.h"
#include "helpers/rational.h"
#include "helpers/shapes.h"
#include "mesh/triangle.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;

namespace {

using test::RationalPoint;
using test::RationalTriangle;

/// Corners have `size` different x and y each, and `layers` different z.
Mesh random_triangles(std::uint64_t seed, std::size_t faces, std::uint64_t size,
                      std::uint64_t layers) {
  test::Random random(seed);
  Mesh mesh;
  while (mesh.faces.size() < faces) {
    std::array<Vec3, 3> t;
    for (Vec3& p : t) {
      const auto below = [&](std::uint64_t bound) {
        return static_cast<double>(random.below(bound));
      };
      const double x = below(size), y = below(size);
      p = Vec3(x, y, below(layers));
    }
    if ((t[1] - t[0]).cross(t[2] - t[0]).isZero(0)) continue;
    const auto base = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), t.begin(), t.end());
    mesh.faces.push_back({base, base + 1, base + 2});
  }
  return mesh;
}

Arrangement arrange_mesh(const Mesh& mesh) {
  const auto welded = std::make_shared<const WeldedMesh>(weld(mesh));
  return arrange(welded, find_meetings(*welded, Progress()), Progress());
}

/// Returns all corners, intersections of edges with faces and other edges, and intersections of
/// three faces.
std::set<RationalPoint> expected_points(const Mesh& mesh) {
  std::vector<RationalTriangle> t;
  for (Index f = 0; f < mesh.faces.size(); ++f) t.push_back(test::exact_triangle(mesh, f));
  std::set<RationalPoint> points;
  const auto add = [&](const std::optional<RationalPoint>& p,
                       std::initializer_list<std::size_t> faces) {
    if (p && std::all_of(faces.begin(), faces.end(),
                         [&](std::size_t f) { return test::contains(t[f], *p); }))
      points.insert(*p);
  };
  for (std::size_t f = 0; f < t.size(); ++f) {
    points.insert(t[f].begin(), t[f].end());
    for (std::size_t g = 0; g < t.size(); ++g) {
      for (std::size_t i = 0; i < 3 && f != g; ++i) {
        const RationalPoint &a = t[f][i], &b = t[f][(i + 1) % 3];
        add(test::crossing(a, b, t[g]), {g});
        for (std::size_t k = 0; k < 3; ++k)
          add(test::crossing(a, b, t[g][k], t[g][(k + 1) % 3]), {f, g});
      }
      for (std::size_t h = g + 1; h < t.size() && f < g; ++h)
        add(test::crossing(t[f], t[g], t[h]), {f, g, h});
    }
  }
  return points;
}

/// Returns the element of `points` at the position of each point of the arrangement. The
/// arrangement must not have points that are missing in `points`.
std::vector<RationalPoint> match_points(const Arrangement& arrangement,
                                        const std::set<RationalPoint>& points) {
  std::vector<RationalPoint> matched;
  for (Index i = 0; i < arrangement.point_count(); ++i) {
    const Vec3 position = arrangement.position(i);
    const auto is_here = [&](const RationalPoint& p) {
      for (int k = 0; k < 3; ++k) {
        const double value = p[static_cast<std::size_t>(k)].convert_to<double>();
        if (std::abs(value - position[k]) > 4e-15) return false;
      }
      return true;
    };
    const auto found = std::find_if(points.begin(), points.end(), is_here);
    REQUIRE(found != points.end());
    matched.push_back(*found);
  }
  return matched;
}

/// Points touch pieces only at corners, so adjacent pieces have equal corners and edges.
void check_conforming(const Arrangement& arrangement, const std::vector<RationalPoint>& points) {
  for (const Piece& piece : arrangement.pieces) {
    const auto& [a, b, c] = piece.corners;
    const RationalTriangle t = {points[a], points[b], points[c]};
    REQUIRE(!test::is_zero(test::normal(t)));
    for (Index i = 0; i < points.size(); ++i) {
      if (i != a && i != b && i != c) REQUIRE(!test::contains(t, points[i]));
    }
  }
}

/// Checks that the area vectors of a face's pieces add up to the area vector of the face. Also
/// checks that the multiplicity of each piece is the sum over its sources.
void check_sources(const Mesh& mesh, const Arrangement& arrangement,
                   const std::vector<RationalPoint>& points) {
  std::vector<RationalPoint> sums(mesh.faces.size(), RationalPoint{0, 0, 0});
  for (const Piece& piece : arrangement.pieces) {
    const auto& [a, b, c] = piece.corners;
    const RationalPoint n = test::normal({points[a], points[b], points[c]});
    int multiplicity = 0;
    for (const PieceSource& source : arrangement.sources_of(piece)) {
      const RationalTriangle face = test::exact_triangle(mesh, source.face);
      for (const Index corner : piece.corners) REQUIRE(test::contains(face, points[corner]));
      REQUIRE((test::dot(test::normal(face), n) < 0) == source.reversed);
      multiplicity += source.reversed ? -1 : 1;
      for (std::size_t k = 0; k < 3; ++k) sums[source.face][k] += source.reversed ? -n[k] : n[k];
    }
    REQUIRE(piece.multiplicity == multiplicity);
    REQUIRE(piece.multiplicity >= 0);
  }
  for (Index f = 0; f < mesh.faces.size(); ++f)
    CHECK(sums[f] == test::normal(test::exact_triangle(mesh, f)));
}

}  // namespace

TEST_CASE("random triangles are cut at all points in which they meet, and no others") {
  std::size_t cut_points = 0, shared = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = random_triangles(seed, 3 + seed % 6, 3 + seed % 3, 1 + seed % 4);
    const Arrangement arrangement = arrange_mesh(mesh);
    REQUIRE(arrangement.welded->faces.size() == mesh.faces.size());
    const std::set<RationalPoint> expected = expected_points(mesh);
    const std::vector<RationalPoint> points = match_points(arrangement, expected);
    CHECK(points.size() == expected.size());
    CHECK(std::set<RationalPoint>(points.begin(), points.end()).size() == points.size());
    check_conforming(arrangement, points);
    check_sources(mesh, arrangement, points);
    cut_points += arrangement.cut_points.size();
    for (const Piece& piece : arrangement.pieces) shared += piece.source_count > 1 ? 1 : 0;
  }
  CHECK(cut_points > 500);
  CHECK(shared > 20);
}

TEST_CASE("faces that meet nothing stay whole, in their order and before all others") {
  const Mesh cubes = test::joined(test::icosphere(2), test::moved(test::icosphere(2), {1, 0.1, 0}));
  const Arrangement arrangement = arrange_mesh(cubes);
  std::vector<char> is_cut(cubes.faces.size(), 0);
  for (const auto& [f, g] : find_intersections(cubes)) is_cut[f] = is_cut[g] = 1;
  std::size_t whole = 0;
  for (Index f = 0; f < cubes.faces.size(); ++f) {
    if (is_cut[f]) continue;
    CHECK(arrangement.pieces[whole].corners == arrangement.welded->faces[f]);
    CHECK(arrangement.sources_of(arrangement.pieces[whole]).front().face == f);
    ++whole;
  }
  CHECK(arrangement.whole_pieces == whole);
  CHECK(whole > 100);
  for (std::size_t p = whole; p < arrangement.pieces.size(); ++p)
    CHECK(is_cut[arrangement.sources_of(arrangement.pieces[p]).front().face] == 1);
}

TEST_CASE("a wall and its reverse cancel out where they overlap") {
  const Mesh wall = test::grid(1);
  const Arrangement twice = arrange_mesh(test::joined(wall, wall));
  const Arrangement both = arrange_mesh(test::joined(wall, test::reversed(wall)));
  CHECK(twice.pieces.size() == 2);
  for (const Piece& piece : twice.pieces) CHECK(piece.multiplicity == 2);
  CHECK(both.pieces.size() == 2);
  for (const Piece& piece : both.pieces) CHECK(piece.multiplicity == 0);

  // Half of each wall coincides with half of the other wall.
  Mesh moved = test::moved(test::reversed(wall), {0.5, 0, 0});
  const Arrangement half = arrange_mesh(test::joined(wall, moved));
  std::array<double, 2> area{};
  for (const Piece& piece : half.pieces) {
    const auto& [a, b, c] = piece.corners;
    const Vec3 n = normal_of(half.position(a), half.position(b), half.position(c));
    area.at(static_cast<std::size_t>(piece.multiplicity)) += n.norm() / 2;
  }
  CHECK(area[0] == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(area[1] == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("the arrangement is the same for any number of threads") {
  const Mesh mesh = random_triangles(7, 40, 6, 6);
  const auto corners = [&] {
    std::vector<Face> faces;
    for (const Piece& piece : arrange_mesh(mesh).pieces) faces.push_back(piece.corners);
    return faces;
  };
  const std::vector<Face> expected = corners();
  const ThreadLimit limit(1);
  CHECK(corners() == expected);
}
