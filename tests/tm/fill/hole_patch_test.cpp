#include "tm/fill/hole_patch.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "tm/mesh/components.h"
#include "tm/mesh/manifold.h"

using namespace transformesh;

TEST_CASE("of patches that are equally good it is always the same one") {
  // A bent tube, around whose ends all edges and angles are nearly the same.
  Mesh tube = test::torus(2, 0.5, 60, 24);
  for (Vec3& p : tube.positions) p = p.cast<float>().cast<double>();
  tube.faces.erase(tube.faces.begin(), tube.faces.begin() + 48);
  tube = select_faces(tube, std::vector<bool>(tube.faces.size(), true));
  const Index border = check_manifold(tube).border_halfedges.front();

  for (const PatchKind kind : {PatchKind::plain, PatchKind::refined}) {
    const auto first = patch_hole(tube, border, kind, Search::delaunay);
    REQUIRE(first.has_value());
    bool is_same = true;
    // While memory comes from ever other places.
    for (int i = 0; i < 300; ++i) {
      const auto again = patch_hole(tube, border, kind, Search::delaunay);
      is_same &= again && again->points == first->points && again->faces == first->faces;
    }
    CHECK(is_same);
  }
}
