#include "fill/homology.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "helpers/shapes.h"
#include "mesh/adjacency.h"

using namespace transformesh;

namespace {

struct Words {
  Mesh mesh;
  std::vector<Index> opposites;
  std::vector<HomologyWord> words;

  explicit Words(Mesh closed)
      : mesh(std::move(closed)),
        opposites(opposite_halfedges(mesh)),
        words(homology_words(mesh, opposites)) {}

  /// Returns the sum of the words along a loop of vertices.
  HomologyWord along(const std::vector<Index>& loop) const {
    HomologyWord sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum ^= words[halfedge(loop[i], loop[(i + 1) % loop.size()])];
    return sum;
  }
  std::size_t halfedge(Index from, Index to) const {
    for (std::size_t h = 0; h < words.size(); ++h)
      if (mesh.faces[h / 3][h % 3] == from && mesh.faces[h / 3][(h + 1) % 3] == to) return h;
    FAIL("no edge from ", from, " to ", to);
    return 0;
  }
};

constexpr int around = 9, across = 6;

/// Loops of test::torus(): around the axis, and around the tube.
std::vector<Index> long_loop(Index j) {
  std::vector<Index> loop;
  for (Index i = 0; i < around; ++i) loop.push_back(i * across + j);
  return loop;
}
std::vector<Index> short_loop(Index i) {
  std::vector<Index> loop;
  for (Index j = 0; j < across; ++j) loop.push_back(i * across + j);
  return loop;
}

}  // namespace

TEST_CASE("every loop separates a sphere: words around faces and vertices cancel") {
  const Words sphere(test::icosphere(2));
  CHECK(std::ranges::all_of(sphere.words, [](HomologyWord word) { return word == 0; }));
}

TEST_CASE("words are the same on both sides of an edge, and cancel around a face") {
  const Words torus(test::torus(2, 1, around, across));
  for (std::size_t h = 0; h < torus.words.size(); ++h)
    CHECK(torus.words[h] == torus.words[torus.opposites[h]]);
  for (const Face& face : torus.mesh.faces) CHECK(torus.along({face[0], face[1], face[2]}) == 0);
}

TEST_CASE("loops around a torus do not separate it, and parallel ones have the same word") {
  const Words torus(test::torus(2, 1, around, across));
  CHECK(torus.along(long_loop(0)) != 0);
  CHECK(torus.along(short_loop(0)) != 0);
  CHECK(torus.along(long_loop(0)) != torus.along(short_loop(0)));
  for (Index j = 1; j < across; ++j) CHECK(torus.along(long_loop(j)) == torus.along(long_loop(0)));
  for (Index i = 1; i < around; ++i)
    CHECK(torus.along(short_loop(i)) == torus.along(short_loop(0)));
}

TEST_CASE("sums of words that were added are not new") {
  IndependentWords words;
  CHECK(!words.is_new(0));
  CHECK(words.is_new(6));
  words.add(6);
  words.add(5);
  CHECK(!words.is_new(6));
  CHECK(!words.is_new(6 ^ 5));
  CHECK(words.is_new(1));
  words.add(1);
  for (HomologyWord word = 0; word < 8; ++word) CHECK(!words.is_new(word));
  CHECK(words.is_new(8));
}
