// Coplanar overlaps of the same and of opposite orientation, coincident faces and sheets, and faces
// folded onto their neighbors.
#include "corpus/build.h"
#include "corpus/cases.h"

namespace transformesh::corpus {
namespace {

/// Boxes that stand on one plane and end in another.
Mesh slabs(int count, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3 low = lattice_point(random, 0, 1 + count / 3);
    const Vec3 side = lattice_point(random, 1, 5);
    mesh = joined(mesh, cuboid({low.x(), low.y(), 0}, {low.x() + side.x(), low.y() + side.y(), 3}));
  }
  return mesh;
}

/// Boxes that touch one plane, half of them from above and half from below.
Mesh abutting(int count, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3 low = lattice_point(random, 0, 1 + count / 4);
    const Vec3 high = low + lattice_point(random, 1, 4);
    const double side = i % 2 == 0 ? 1 : -1;
    mesh = joined(mesh, cuboid({low.x(), low.y(), std::min(0.0, side)},
                               {high.x(), high.y(), std::max(0.0, side)}));
  }
  return mesh;
}

Mesh copies(const Mesh& mesh, int count, int reversed_count) {
  Mesh result;
  for (int i = 0; i < count; ++i) result = joined(result, mesh);
  for (int i = 0; i < reversed_count; ++i) result = joined(result, reversed(mesh));
  return result;
}

/// A box with a finely triangulated lid. Some inner vertices of the lid are moved within its plane
/// by `shift` cells, so that neighboring faces fold onto each other.
Mesh folded_lid(int cells, double shift, std::uint64_t seed) {
  Mesh lid = grid(cells);
  Mesh bottom = reversed(moved(lid, {0, 0, -1}));
  Mesh mesh = joined(lid, bottom);
  const auto at = [&](int i, int j, bool low) {
    return static_cast<Index>(i * (cells + 1) + j) +
           (low ? static_cast<Index>(lid.positions.size()) : 0);
  };
  const auto wall = [&](int i, int j, int k, int l) {
    mesh.faces.push_back({at(i, j, true), at(k, l, true), at(k, l, false)});
    mesh.faces.push_back({at(i, j, true), at(k, l, false), at(i, j, false)});
  };
  for (int i = 0; i < cells; ++i) {
    wall(i, 0, i + 1, 0);
    wall(i + 1, cells, i, cells);
    wall(0, i + 1, 0, i);
    wall(cells, i, cells, i + 1);
  }
  Random random(seed);
  for (int i = 1; i < cells; ++i)
    for (int j = 1; j < cells; ++j) {
      if (random.below(3) != 0) continue;
      const Vec3 direction = lattice_point(random, -1, 1);
      mesh.positions[at(i, j, false)] += shift / cells * Vec3(direction.x(), direction.y(), 0);
    }
  return mesh;
}

/// Two coincident sheets of opposite orientation inside a box, or joined to it: a closed surface
/// without volume.
Mesh pillow(int cells) { return joined(grid(cells), reversed(grid(cells))); }

/// Both sides of one sheet, on the same vertices.
Mesh flat_triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  mesh.faces = {{0, 1, 2}, {0, 2, 1}};
  return mesh;
}

void add_slabs(Cases& cases) {
  for (const int count : {2, 3, 5, 8, 20})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const std::string name = named("boxes", count) + "/" + named("seed", static_cast<long>(seed));
      cases.push_back({"coplanar-same", name, [=] { return slabs(count, seed); }});
      cases.push_back({"coplanar-opposite", name, [=] { return abutting(count, seed); }});
      cases.push_back({"nearly-coplanar", "turned-slabs/" + name,
                       [=] { return turned(slabs(count, seed)); }, Outcome::clean, 1, true, 1e-16});
      cases.push_back({"nearly-coplanar", "turned-abutting/" + name,
                       [=] { return turned(abutting(count, seed)); }, Outcome::clean, 1, true,
                       1e-16});
    }
}

void add_copies(Cases& cases) {
  for (const int count : {2, 3, 5}) {
    const std::string name = named("copies", count);
    cases.push_back({"coincident", name + "/cube", [=] { return copies(cube(), count, 0); }});
    cases.push_back(
        {"coincident", name + "/cube-less-one", [=] { return copies(cube(), count, count - 1); }});
    cases.push_back(
        {"coincident", name + "/sphere", [=] { return copies(test::icosphere(1), count, 0); }});
    cases.push_back({"coincident", name + "/turned-sphere",
                     [=] { return copies(turned(test::icosphere(1)), count, 1); }});
    cases.push_back({"coincident", name + "/other-diagonals", [=] {
                       const Mesh other = moved(stretched(cube(), {-1, 1, 1}), {1, 0, 0});
                       return copies(joined(cube(), reversed(other)), count, 0);
                     }});
    cases.push_back({"coincident", name + "/cancelled",
                     [=] { return copies(cube(), count, count); }, Outcome::inside_out});
  }
}

void add_sheets(Cases& cases) {
  for (const int cells : {1, 3, 6}) {
    const std::string name = named("cells", cells);
    cases.push_back({"coincident", name + "/sheets-in-box", [=] {
                       return joined(cuboid({-1, -1, -1}, {2, 2, 2}), pillow(cells));
                     }});
    cases.push_back({"coincident", name + "/sheets-through-box", [=] {
                       return joined(cuboid({0.25, 0.25, -1}, {2, 2, 2}), pillow(cells));
                     }});
    cases.push_back({"coincident", name + "/sheets-on-box", [=] {
                       return joined(cuboid({0.25, 0.25, 0}, {2, 2, 2}), pillow(cells));
                     }});
    cases.push_back(
        {"coincident", name + "/sheets", [=] { return pillow(cells); }, Outcome::inside_out});
  }
  cases.push_back({"coincident", "flat-triangle", flat_triangle, Outcome::inside_out});
  cases.push_back({"coincident", "flat-triangle-and-cube", [] {
                     return joined(flat_triangle(), cuboid({1, 1, -1}, {2, 2, 1}));
                   }});
}

}  // namespace

void add_coplanar_cases(Cases& cases) {
  add_slabs(cases);
  add_copies(cases);
  add_sheets(cases);

  for (const int cells : {3, 4, 8})
    for (const double shift : {1.0, 1.5, 2.0, 3.0})
      for (std::uint64_t seed = 1; seed <= 2; ++seed)
        cases.push_back({"folded-flat",
                         named("cells", cells) + "/" + named("shift", std::lround(10 * shift)) +
                             "/" + named("seed", static_cast<long>(seed)),
                         [=] { return folded_lid(cells, shift, seed); }});
}

}  // namespace transformesh::corpus
