/// Winding numbers by rays, against sums of solid angles, and by closed forms where rays graze.
#include "clean/exterior/ray_cast_front_winding.h"

#include <doctest/doctest.h>

#include "helpers/arrangement_facts.h"
#include "mesh/manifold.h"

namespace transformesh {
namespace {

/// The surface of a cube about the origin, cut into n * n unit squares on each side.
void add_lattice_cube(Mesh& mesh, int n) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const Vec3 u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3);
      for (int i = 0; i < n * n; ++i) {
        const Vec3 shift = (i % n) * u + (i / n) * v;
        const Vec3 corner = n / 2.0 * (side * Vec3::Unit(axis) - u - v) + shift;
        const auto base = static_cast<Index>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(),
                              {corner, corner + u, corner + u + v, corner + v});
        const Index b = side > 0 ? base + 1 : base + 3, d = side > 0 ? base + 3 : base + 1;
        mesh.faces.insert(mesh.faces.end(), {{base, b, base + 2}, {base, base + 2, d}});
      }
    }
  }
}

/// The only border of a mesh as a loop along its faces.
std::vector<Index> border_loop(const Mesh& mesh) {
  std::map<Index, Index> next;
  for (const Index h : check_manifold(mesh).border_halfedges)
    next[halfedge_source(mesh, h)] = halfedge_target(mesh, h);
  std::vector<Index> loop{next.begin()->first};
  while (next[loop.back()] != loop.front()) loop.push_back(next[loop.back()]);
  return loop;
}

}  // namespace

TEST_CASE("w in front of every piece is that of solid angles, with and without a hierarchy") {
  std::size_t tested = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = test::random_balls(seed, 4);
    const Arrangement arrangement = test::arranged(mesh);
    const RayCastFrontWinding few(arrangement, BorderClosure(), 1);
    const RayCastFrontWinding many(arrangement, BorderClosure(), 1000);
    for (const Piece& piece : arrangement.pieces) {
      const int winding = many.in_front_of(piece);
      REQUIRE(few.in_front_of(piece) == winding);
      const auto expected = test::winding_beside(mesh, test::corners_of(arrangement, piece), 1);
      if (!expected) continue;
      REQUIRE(winding == *expected);
      ++tested;
    }
  }
  CHECK(tested > 1500);
}

TEST_CASE("rays along a lattice, where corners lie behind corners, count right") {
  // In front of the k-th cube from outside there are k others.
  Mesh mesh;
  std::vector<int> expected;
  for (const int n : {5, 3, 1}) {
    const int around = (5 - n) / 2;
    add_lattice_cube(mesh, n);
    expected.resize(mesh.faces.size(), around);
  }
  const Arrangement arrangement = test::arranged(mesh);
  REQUIRE(arrangement.whole_pieces == mesh.faces.size());
  for (const std::size_t rays : {std::size_t{1}, mesh.faces.size()}) {
    const RayCastFrontWinding ray(arrangement, BorderClosure(), rays);
    for (std::size_t p = 0; p < expected.size(); ++p)
      CHECK(ray.in_front_of(arrangement.pieces[p]) == expected[p]);
  }
}

TEST_CASE("a ray meets what closes the borders") {
  // A ball without its northern cap, within a ball: all its faces look into the outer one.
  Mesh bowl = test::icosphere(3);
  std::erase_if(bowl.faces, [&](const Face& f) {
    return std::any_of(f.begin(), f.end(), [&](Index v) { return bowl.positions[v].z() > 0.8; });
  });
  const Mesh mesh = test::joined(bowl, test::scaled(test::icosphere(3), 2));
  const Arrangement arrangement = test::arranged(mesh);
  const BorderClosure closure = close_borders(*arrangement.welded, {border_loop(bowl)});
  CHECK(closure.triangles.size() == border_loop(bowl).size());
  const RayCastFrontWinding ray(arrangement, closure, mesh.faces.size());
  for (std::size_t p = 0; p < arrangement.pieces.size(); ++p)
    CHECK(ray.in_front_of(arrangement.pieces[p]) == (p < bowl.faces.size() ? 1 : 0));

  // Reversed, its faces look into what it encloses, from where w is one less.
  const Mesh reversed = test::joined(test::reversed(bowl), test::scaled(test::icosphere(3), 2));
  const Arrangement inwards = test::arranged(reversed);
  std::vector<Index> loop = border_loop(bowl);
  std::reverse(loop.begin(), loop.end());
  const BorderClosure inner = close_borders(*inwards.welded, {loop});
  const RayCastFrontWinding inner_ray(inwards, inner, mesh.faces.size());
  for (std::size_t p = 0; p < bowl.faces.size(); ++p)
    CHECK(inner_ray.in_front_of(inwards.pieces[p]) == 0);
}

}  // namespace transformesh
