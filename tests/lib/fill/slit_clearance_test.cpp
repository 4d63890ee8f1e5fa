#include "fill/slit_clearance.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "mesh/adjacency.h"

using namespace transformesh;

namespace {

constexpr int around = 24, across = 10;

/// A torus and another part of the surface. Decides whether the tube can be cut through at the
/// angle of vertex `at`. The torus begins at vertex 0.
class Tube {
 public:
  explicit Tube(const Mesh& other)
      : mesh_(test::joined(test::torus(2, .5, around, across), other)),
        stars_(mesh_, opposite_halfedges(mesh_)),
        clearance_(mesh_, stars_) {}

  bool is_free(Index at, bool takes = false) {
    std::vector<Index> loop;
    for (Index j = 0; j < across; ++j) loop.push_back(at * across + j);
    const SlitSides sides = sides_of(mesh_, loop, stars_);
    const auto patch = patch_of_slit(mesh_, loop, sides, stars_);
    REQUIRE(patch);
    const ClosedSlit slit = drawn_apart(mesh_, loop, sides, *patch, Scalar::float64);
    const bool is_free = clearance_.is_free(loop, sides, slit);
    if (takes) clearance_.take(loop, sides, slit);
    return is_free;
  }

 private:
  Mesh mesh_;
  HalfedgeStars stars_;
  SlitClearance clearance_;
};

/// A small cavity around a point.
Mesh cavity(const Vec3& at, double radius) {
  return test::reversed(test::moved(test::scaled(test::icosphere(1), radius), at));
}

}  // namespace

TEST_CASE("an empty tube, also beside another body, is free") {
  CHECK(Tube(Mesh()).is_free(0));
  CHECK(Tube(test::moved(test::icosphere(1), {2, 0, 3})).is_free(0));
}

TEST_CASE("a cavity in the slab, small or as wide as the tube, is in the way") {
  CHECK(!Tube(cavity({2, 0, 0}, .02)).is_free(0));
  CHECK(!Tube(cavity({2, 0, 0}, .4)).is_free(0));
}

TEST_CASE("a cavity elsewhere in the tube does not block a slit") {
  Tube tube(cavity({-2, 0, 0}, .3));
  CHECK(tube.is_free(0));
  CHECK(!tube.is_free(around / 2));
}

TEST_CASE("a used slit blocks only slits at the same place") {
  Tube tube{Mesh()};
  CHECK(tube.is_free(0, true));
  CHECK(!tube.is_free(0));
  CHECK(tube.is_free(around / 2));
}
