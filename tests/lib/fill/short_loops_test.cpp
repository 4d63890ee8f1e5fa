/// Short loops, compared with closed forms, and with all loops of tiny meshes.
#include "fill/short_loops.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <set>

#include "helpers/shapes.h"
#include "mesh/adjacency.h"
#include "mesh/disjoint_sets.h"
#include "transformesh/shapes.h"

using namespace transformesh;

namespace {

constexpr double any_length = 1e9;

std::vector<ShortLoop> loops_of(const Mesh& mesh, double max_length = any_length) {
  return short_loops(mesh, HalfedgeStars(mesh, opposite_halfedges(mesh)), max_length);
}

/// Returns whether cutting the loop's edges leaves the number of connected components unchanged.
bool keeps_together(const Mesh& mesh, const std::vector<Index>& loop) {
  std::set<std::pair<Index, Index>> cut;
  for (std::size_t i = 0; i < loop.size(); ++i)
    cut.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
  const std::vector<Index> opposites = opposite_halfedges(mesh);
  DisjointSets before(mesh.faces.size()), after(mesh.faces.size());
  std::size_t joins = 0;
  for (Index h = 0; h < opposites.size(); ++h) {
    if (before.join(h / 3, opposites[h] / 3)) ++joins;
    const std::pair<Index, Index> edge =
        std::minmax(halfedge_source(mesh, h), halfedge_target(mesh, h));
    if (cut.count(edge) == 0 && after.join(h / 3, opposites[h] / 3)) --joins;
  }
  return joins == 0;
}

/// Finds the length of the shortest simple loop that does not separate the faces, by trying all.
class AllLoops {
 public:
  explicit AllLoops(const Mesh& mesh) : mesh_(mesh), next_(mesh.positions.size()) {
    for (const Face& face : mesh.faces)
      for (int i = 0; i < 3; ++i) next_[face.at(i)].push_back(face.at((i + 1) % 3));
  }

  double shortest() {
    for (Index first = 0; first < next_.size(); ++first) go_on({first}, 0);
    return shortest_;
  }

 private:
  void go_on(std::vector<Index> path, double length) {
    for (const Index v : next_[path.back()]) {
      const double longer = length + (mesh_.positions[v] - mesh_.positions[path.back()]).norm();
      if (longer >= shortest_ || v < path.front()) continue;
      if (v == path.front()) {
        if (path.size() > 2 && keeps_together(mesh_, path)) shortest_ = longer;
      } else if (std::find(path.begin(), path.end(), v) == path.end()) {
        path.push_back(v);
        go_on(path, longer);
        path.pop_back();
      }
    }
  }

  const Mesh& mesh_;
  std::vector<std::vector<Index>> next_;
  double shortest_ = any_length;
};

}  // namespace

TEST_CASE(
    "the shortest loop of a torus goes around its tube, and that through its hole is another") {
  const Mesh mesh = test::torus(2, 0.5, 60, 24);
  const std::vector<ShortLoop> loops = loops_of(mesh);
  REQUIRE(!loops.empty());
  const double around_tube = 24 * std::sin(std::numbers::pi / 24);
  CHECK(loops.front().length == doctest::Approx(around_tube));
  CHECK(loops.front().vertices.size() == 24);

  // For this thick torus, the loop through the hole is shorter than that around the tube.
  const Mesh thick = test::torus(2, 1.9, 12, 80);
  const double around_hole = 2 * 12 * (2 - 1.9) * std::sin(std::numbers::pi / 12);
  CHECK(loops_of(thick).front().length == doctest::Approx(around_hole));
  CHECK(loops_of(thick, 0.99 * around_hole).empty());
}

TEST_CASE("surfaces without handles have no such loops, however thin they are") {
  CHECK(loops_of(test::icosphere(3)).empty());
  CHECK(loops_of(test::tetrahedron()).empty());
  ShapeOptions dumbbell;
  dumbbell.kind = "dumbbell";
  dumbbell.faces = 2000;
  CHECK(loops_of(make_shape(dumbbell)).empty());
}

TEST_CASE("loops that are found do not separate, and ascend") {
  for (const int holes : {1, 2, 5}) {
    ShapeOptions options;
    options.kind = "genus";
    options.parameters = {std::to_string(holes)};
    options.faces = 4000;
    const Mesh mesh = make_shape(options);
    IndependentWords independent;
    std::size_t classes = 0;
    double last = 0;
    for (const ShortLoop& loop : loops_of(mesh)) {
      CHECK(loop.length >= last);
      last = loop.length;
      CHECK(std::set<Index>(loop.vertices.begin(), loop.vertices.end()).size() ==
            loop.vertices.size());
      if (!independent.is_new(loop.word)) continue;
      independent.add(loop.word);
      ++classes;
      CHECK(keeps_together(mesh, loop.vertices));
    }
    CHECK(classes >= static_cast<std::size_t>(holes));
    CHECK(classes <= 2 * static_cast<std::size_t>(holes));
  }
}

TEST_CASE("no loop of a tiny torus is shorter than the one found") {
  for (unsigned seed = 0; seed < 12; ++seed) {
    Mesh mesh = test::torus(2, 1, 4, 4);
    std::mt19937 random(seed);
    for (Vec3& p : mesh.positions)
      for (double& x : p) x += static_cast<double>(random() % 1000) / 700;
    const std::vector<ShortLoop> loops = loops_of(mesh);
    REQUIRE(!loops.empty());
    CHECK(keeps_together(mesh, loops.front().vertices));
    CHECK(loops.front().length == doctest::Approx(AllLoops(mesh).shortest()));
  }
}

TEST_CASE("words that are sums of others are not new") {
  IndependentWords words;
  words.add(5);
  words.add(6);
  CHECK(!words.is_new(3));
  CHECK(!words.is_new(0));
  CHECK(words.is_new(1));
  CHECK(words.is_new(8));
}
