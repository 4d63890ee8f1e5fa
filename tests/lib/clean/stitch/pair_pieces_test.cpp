/// Pairs of pieces, compared with pairs that are found without the welded mesh.
#include "clean/stitch/pair_pieces.h"

#include <doctest/doctest.h>

#include "clean/exterior/angular_order.h"
#include "clean/exterior/exterior.h"
#include "clean/stitch/pair_halfedges.h"
#include "helpers/arrangement_facts.h"

using namespace transformesh;

namespace {

void check_pairs(const Arrangement& arrangement, const std::vector<char>& kept) {
  const Edges edges = piece_edges(arrangement, kept);
  std::vector<Face> faces(arrangement.pieces.size(), Face{0, 0, 0});
  for (std::size_t p = 0; p < faces.size(); ++p)
    if (kept[p]) faces[p] = arrangement.pieces[p].corners;
  const auto sort = [&](std::span<const Index> halfedges) {
    return sort_around_edge(arrangement, halfedges);
  };
  const std::vector<Index> expected = pair_across_inside(faces, edges, sort);
  bool has_singular_edges = false;
  for (std::size_t e = 0; e < edges.size(); ++e)
    has_singular_edges |= edges.halfedges(e).size() > 2;

  const PiecePairs pairs = pair_pieces(arrangement, kept);
  CHECK(pairs.has_singular_edges == has_singular_edges);
  CHECK(std::equal(pairs.opposite.begin(), pairs.opposite.end(), expected.begin(), expected.end()));
}

}  // namespace

TEST_CASE("pieces of balls are paired as in a mesh of all kept pieces") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const Arrangement arrangement = test::arranged(test::random_balls(seed, 4));
    check_pairs(arrangement, find_exterior_by_rays(arrangement, 1, Progress()));
    check_pairs(arrangement, find_exterior_by_rays(arrangement, 2, Progress()));
  }
}

TEST_CASE("reversed whole pieces are paired by their own corners") {
  Arrangement arrangement = test::arranged(test::random_balls(1, 4));
  std::vector<char> kept(arrangement.pieces.size(), 1);
  for (std::size_t p = 0; p < kept.size(); ++p)
    if (p % 3 == 0) reverse_piece(arrangement, arrangement.pieces[p]);
  for (std::size_t p = 0; p < kept.size(); p += 5) kept[p] = 0;
  check_pairs(arrangement, kept);
}

TEST_CASE("kept pieces keep their opposites under their new numbers") {
  const std::vector<Index> moved = opposites_of_kept(
      {no_index, no_index, no_index, 7, no_index, no_index, no_index, 3, no_index}, {0, 1, 1}, 2);
  CHECK(moved == std::vector<Index>{4, no_index, no_index, no_index, 0, no_index});
}
