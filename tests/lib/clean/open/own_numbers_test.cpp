#include "clean/open/own_numbers.h"

#include <doctest/doctest.h>

#include <cmath>

#include "clean/exterior/angular_order.h"
#include "helpers/arrangement_facts.h"
#include "mesh/disjoint_sets.h"

using namespace transformesh;

namespace {

/// Balls that intersect each other and a sheet beside them, as one open component. With
/// `has_holes`, the balls lack some faces.
Arrangement cut_balls(std::uint64_t seed, bool has_holes) {
  test::Random random(seed);
  Mesh mesh = test::random_balls(seed, 6);
  if (has_holes) std::erase_if(mesh.faces, [&](const Face&) { return random.below(50) == 0; });
  mesh = test::joined(mesh, test::moved(test::grid(2), {3, 0, 0}));
  return test::arranged_open(mesh, std::vector<Index>(mesh.faces.size(), 0));
}

struct Patches {
  std::vector<std::vector<Index>> pieces;
  std::vector<NumberBounds> bounds;
};

/// Connects pieces across edges of two pieces, and bounds the winding numbers of these patches.
Patches bounded_patches(const Arrangement& arrangement, ComponentWinding& winding) {
  OwnNumbers numbers(arrangement, winding);
  DisjointSets sets(arrangement.pieces.size());
  const Edges edges = piece_edges(arrangement, std::vector<char>(arrangement.pieces.size(), 1));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() == 2) sets.join(halfedges[0] / 3, halfedges[1] / 3);
    if (halfedges.size() > 2) numbers.add_edge(sort_around_edge(arrangement, halfedges), 0);
  }
  std::map<Index, std::vector<Index>> members;
  for (Index p = 0; p < arrangement.pieces.size(); ++p) members[sets.find(p)].push_back(p);
  Patches result;
  for (const auto& [name, pieces] : members) result.pieces.push_back(pieces);
  std::vector<const std::vector<Index>*> lists;
  for (const std::vector<Index>& pieces : result.pieces) lists.push_back(&pieces);
  result.bounds = numbers.bound(0, lists);
  return result;
}

/// True if no face passes so close to the centroid of a piece that rounding could move it across.
bool is_thick(const Arrangement& arrangement, Index piece) {
  const Triangle t = test::corners_of(arrangement, arrangement.pieces[piece]);
  return normal_of(t[0], t[1], t[2]).norm() > 1e-6;
}

}  // namespace

TEST_CASE("bounds of patches contain the winding numbers of their pieces") {
  int checked = 0, narrow = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const Arrangement arrangement = cut_balls(seed, seed % 2 == 0);
    ComponentWinding winding(arrangement);
    const Patches patches = bounded_patches(arrangement, winding);
    for (std::size_t i = 0; i < patches.pieces.size(); ++i) {
      const auto& [low, high] = patches.bounds[i];
      for (const Index p : patches.pieces[i]) {
        if (!is_thick(arrangement, p)) continue;
        const double number = winding.number_at(0, p);
        CHECK(low <= number);
        CHECK(number <= high);
        ++checked;
      }
      if (high - low < .5) ++narrow;
    }
  }
  CHECK(checked > 1000);
  CHECK(narrow > 50);
}

TEST_CASE("steps across an intersection curve are those of the winding numbers beside it") {
  // Two balls and a sheet that is far away. The numbers of the patches differ by 1 across the
  // curve.
  Mesh mesh = test::joined(test::icosphere(2), test::moved(test::icosphere(2), {.9, .1, .2}));
  mesh = test::joined(mesh, test::moved(test::grid(2), {10, 0, 0}));
  const Arrangement arrangement =
      test::arranged_open(mesh, std::vector<Index>(mesh.faces.size(), 0));
  ComponentWinding winding(arrangement);
  const Patches patches = bounded_patches(arrangement, winding);
  int near_half = 0, near_three_halves = 0;
  for (const auto& [low, high] : patches.bounds) {
    if (low > .3 && high < .7) ++near_half;
    if (low > 1.3 && high < 1.7) ++near_three_halves;
  }
  // Each ball has a patch inside the other ball and one outside of it. The sheet has no bounds.
  CHECK(patches.bounds.size() == 5);
  CHECK(near_half == 2);
  CHECK(near_three_halves == 2);
}
