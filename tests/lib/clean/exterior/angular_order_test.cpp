/// The order of faces around an edge, compared with angles in doubles, and with directions on a
/// lattice, many of which are equal or opposite.
#include "clean/exterior/angular_order.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>

#include "helpers/arrangement_facts.h"
#include "helpers/random.h"

using namespace transformesh;

namespace {

/// Faces around the edge from vertex 0 to vertex 1, each with its own third vertex. Forward faces
/// traverse the edge from 0 to 1.
struct Book {
  Mesh mesh;
  std::vector<Index> halfedges;
  std::vector<char> is_forward;

  Book(const Vec3& from, const Vec3& to) { mesh.positions = {from, to}; }
  void add(const Vec3& corner, bool forward, Index rotation) {
    const auto v = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(corner);
    Face face = forward ? Face{0, 1, v} : Face{1, 0, v};
    std::rotate(face.begin(), face.begin() + rotation, face.end());
    halfedges.push_back(static_cast<Index>(3 * mesh.faces.size()) + (3 - rotation) % 3);
    is_forward.push_back(forward ? 1 : 0);
    mesh.faces.push_back(face);
  }
};

Book random_book(test::Random& random, int pages) {
  const Vec3 from = random.point(-1, 1), to = random.point(-1, 1);
  Book book(from, to);
  for (int i = 0; i < pages; ++i) {
    const Vec3 corner = random.point(-2, 2);
    const bool forward = random.below(2) == 0;
    book.add(corner, forward, static_cast<Index>(random.below(3)));
  }
  return book;
}

/// Returns the angle of each face of the book about the edge, relative to the first face. Angles
/// are counterclockwise if viewed against the direction of the edge.
std::vector<double> angles_of(const Book& book) {
  const auto& p = book.mesh.positions;
  const Vec3 axis = (p[1] - p[0]).normalized();
  const Vec3 x = ((p[2] - p[0]) - (p[2] - p[0]).dot(axis) * axis).normalized(), y = axis.cross(x);
  std::vector<double> angles;
  for (std::size_t i = 2; i < p.size(); ++i) {
    const double angle = std::atan2((p[i] - p[0]).dot(y), (p[i] - p[0]).dot(x));
    angles.push_back(i == 2 ? 0 : angle < 0 ? angle + 2 * std::numbers::pi : angle);
  }
  return angles;
}

/// Returns the halfedges of a book, sorted by `before`, which compares indices of its faces.
template <class Before>
std::vector<Index> halfedges_by(const Book& book, const Before& before) {
  std::vector<Index> order(book.halfedges.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), before);
  for (Index& i : order) i = book.halfedges[i];
  return order;
}

}  // namespace

TEST_CASE("faces around an edge are sorted by angle") {
  test::Random random(1);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    const Book book = random_book(random, 2 + round % 9);
    const std::vector<double> angles = angles_of(book);
    const auto before = [&](Index a, Index b) { return angles[a] < angles[b]; };
    CHECK(sort_around_edge(book.mesh, book.halfedges) == halfedges_by(book, before));
  }
}

TEST_CASE("swapping the ends of the edge reverses the order") {
  test::Random random(4);
  for (int round = 0; round < 50; ++round) {
    const Book book = random_book(random, 6);
    Mesh swapped = book.mesh;
    std::swap(swapped.positions[0], swapped.positions[1]);
    for (Face& face : swapped.faces)
      for (Index& v : face) v = v < 2 ? 1 - v : v;
    std::vector<Index> there = sort_around_edge(book.mesh, book.halfedges);
    std::reverse(there.begin() + 1, there.end());
    CHECK(there == sort_around_edge(swapped, book.halfedges));
  }
}

TEST_CASE("equal and opposite directions are distinguished exactly; forward faces come first") {
  constexpr std::array<std::array<int, 2>, 8> directions{
      {{1, 0}, {2, 1}, {0, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {0, -1}, {2, -1}}};
  test::Random random(5);
  for (int round = 0; round < 100; ++round) {
    CAPTURE(round);
    Book book({0, 0, 0}, {0, 0, 1e5});
    std::vector<std::size_t> direction;
    const std::size_t first = random.below(8);
    for (int i = 0; i < 12; ++i) {
      const std::size_t k = i == 0 ? first : random.below(8);
      const double scale = static_cast<double>(1 + random.below(1000));
      const Vec3 corner(scale * directions.at(k)[0], scale * directions.at(k)[1],
                        static_cast<double>(random.below(1000)));
      const bool forward = random.below(2) == 0;
      book.add(corner, forward, static_cast<Index>(random.below(3)));
      direction.push_back((k + 8 - first) % 8);
    }
    const auto before = [&](Index a, Index b) {
      if (direction[a] != direction[b]) return direction[a] < direction[b];
      if (book.is_forward[a] != book.is_forward[b]) return book.is_forward[a] > book.is_forward[b];
      return a < b;
    };
    CHECK(sort_around_edge(book.mesh, book.halfedges) == halfedges_by(book, before));
  }
}

TEST_CASE("adjacent faces around an intersection curve agree about the winding number between") {
  const Mesh mesh = test::random_balls(2, 5);
  const Arrangement arrangement = test::arranged(mesh);
  const auto& pieces = arrangement.pieces;
  const Edges edges = piece_edges(arrangement, std::vector<char>(pieces.size(), 1));
  const auto beside = [&](Index h, bool is_front) {
    const Triangle t = test::corners_of(arrangement, pieces[h / 3]);
    return test::winding_beside(mesh, t, is_front ? 1 : -1);
  };
  std::size_t tested = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() < 4) continue;
    const std::vector<Index> sorted = sort_around_edge(arrangement, halfedges);
    REQUIRE(std::is_permutation(sorted.begin(), sorted.end(), halfedges.begin(), halfedges.end()));
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const Index h = sorted[i], next = sorted[(i + 1) % sorted.size()];
      const auto after = beside(h, is_forward(pieces, h));
      const auto before = beside(next, !is_forward(pieces, next));
      if (!after || !before) continue;
      REQUIRE(*after == *before);
      ++tested;
    }
  }
  CHECK(tested > 300);
}

TEST_CASE("edges of an arrangement are those of the pieces that are included") {
  const Arrangement arrangement = test::arranged(test::cube());
  std::vector<char> included(12, 1);
  CHECK(piece_edges(arrangement, included).size() == 18);
  included[0] = 0;
  const Edges open = piece_edges(arrangement, included);
  CHECK(open.size() == 18);
  std::size_t borders = 0;
  for (std::size_t e = 0; e < open.size(); ++e) {
    borders += open.halfedges(e).size() == 1 ? 1 : 0;
    for (const Index h : open.halfedges(e)) CHECK(h / 3 != 0);
  }
  CHECK(borders == 3);
}
