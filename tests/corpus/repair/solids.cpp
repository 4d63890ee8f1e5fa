// Makes undamaged solids, and checks whether a mesh is a solid.
#include "corpus/repair/damage.h"
#include "helpers/cgal_boolean.h"
#include "helpers/cgal_oracle.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"

namespace transformesh::corpus {
namespace {

/// Largest relative difference between volumes that count as equal. It allows for rounding and for
/// the patches of small holes.
constexpr double same_volume = 1e-3;

Mesh bracket() {
  const Mesh floor = test::cuboid({0, 0, 0}, {4, 2, 0.5}),
             wall = test::cuboid({0, 0, 0}, {0.5, 2, 3});
  const Mesh hole = test::cuboid({2, 0.5, -1}, {3, 1.5, 1});
  return test::cgal_booleans(test::cgal_booleans(floor, wall).united, hole).difference;
}

Mesh hollow_ball() {
  return test::joined(test::icosphere(3), test::reversed(test::scaled(test::icosphere(2), 0.5)));
}

}  // namespace

std::vector<Solid> solids() {
  std::vector<Solid> all{{"cube", test::cube(), 0},
                         {"sphere", test::icosphere(3), 0},
                         {"torus", test::torus(2, 0.7, 40, 24), 0},
                         {"bracket", bracket(), 0},
                         {"hollow-ball", hollow_ball(), 0}};
  for (Solid& solid : all) solid.volume = test::signed_volume(solid.mesh);
  return all;
}

std::string fault_of(const Mesh& repaired, double volume) {
  const test::Count count = test::count(repaired);
  if (!count.is_closed_and_oriented || !count.is_manifold || count.has_isolated_vertices)
    return "no closed oriented manifold";
  if (test::count_self_intersections_apart(repaired) > 0) return "intersects itself";
  const double is = test::signed_volume(repaired);
  if (is <= 0) return "inside out";
  if (volume > 0 && std::abs(is - volume) > same_volume * volume)
    return "volume " + std::to_string(is / volume) + " of the solid's";
  return "";
}

}  // namespace transformesh::corpus
