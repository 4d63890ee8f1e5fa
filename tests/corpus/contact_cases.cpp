// Contacts: edges through vertices and edges, vertices on faces, many faces through one point or
// one axis, components that touch, many intersections in one face.
#include "corpus/build.h"
#include "corpus/cases.h"

namespace transformesh::corpus {
namespace {

/// Small lattice tetrahedra. Their edges often pass through vertices and edges of other tetrahedra.
Mesh lattice_tetrahedra(int count, long size, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) mesh = joined(mesh, lattice_tetrahedron(random, 0, size));
  return mesh;
}

/// An octahedron with corners on the axes.
Mesh octahedron(double radius) {
  Mesh mesh;
  mesh.positions = {{radius, 0, 0},  {-radius, 0, 0}, {0, radius, 0},
                    {0, -radius, 0}, {0, 0, radius},  {0, 0, -radius}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

/// A cube of side 4, and a tetrahedron with one corner at `tip` that extends in the direction
/// `away`.
Mesh spike(const Vec3& tip, const Vec3& away) {
  const Vec3 side = away.unitOrthogonal();
  const Vec3 other = away.cross(side);
  return joined(cuboid({0, 0, 0}, {4, 4, 4}),
                tetrahedron(tip, tip + away + side, tip + away - side, tip + away + other));
}

void add_spikes(Cases& cases) {
  const std::vector<std::pair<std::string, Vec3>> tips = {
      {"face", {2, 1, 4}}, {"diagonal", {2, 2, 4}}, {"edge", {2, 4, 4}}, {"corner", {4, 4, 4}}};
  const std::vector<std::pair<std::string, Vec3>> directions = {{"outwards", {0.5, 0.25, 2}},
                                                                {"inwards", {-0.5, -0.25, -2}},
                                                                {"through", {-0.5, -0.25, -6}},
                                                                {"along", {2, 0.5, 0}}};
  for (const auto& tip : tips)
    for (const auto& direction : directions)
      cases.push_back({"vertex-on-face", tip.first + "/" + direction.first,
                       [=] { return spike(tip.second, direction.second); }});
}

/// Bipyramids on one axis. All faces meet in the two apexes or intersect in the axis.
Mesh star(int count, int sides) {
  Mesh mesh;
  for (int i = 0; i < count; ++i)
    mesh = joined(mesh, bipyramid(sides, 1, 1.5, 2 * std::numbers::pi * i / sides / count));
  return mesh;
}

/// Wedges around the z axis. Each has an edge on the axis or intersects it.
Mesh fan(int count, bool crosses) {
  Mesh mesh;
  const double angle = std::numbers::pi / count;
  for (int i = 0; i < count; ++i) {
    const Vec3 a(std::cos(2 * angle * i), std::sin(2 * angle * i), 0);
    const Vec3 b(std::cos(2 * angle * i + angle), std::sin(2 * angle * i + angle), 0);
    const Vec3 back = crosses ? Vec3(-0.5 * (a + b)) : Vec3(0, 0, 0);
    mesh = joined(mesh, tetrahedron(back, a, b, {0, 0, 1}));
    mesh = joined(mesh, tetrahedron({0, 0, 0}, a, b, {0, 0, -1}));
  }
  return mesh;
}

/// Tetrahedra whose faces lie in planes through the origin.
Mesh burst(int count, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  while (count-- > 0) {
    Mesh part = lattice_tetrahedron(random, -6, 6);
    const Vec3 by =
        count % 2 == 0 ? part.positions[0] : Vec3((part.positions[0] + part.positions[1]) / 2);
    mesh = joined(mesh, moved(part, -by));
  }
  return mesh;
}

/// A plate and `count` spikes through it. All cuts lie in the two large faces of each side.
Mesh bed_of_nails(int count, bool on_lattice_points, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = cuboid({0, 0, 0}, {64, 64, 1});
  for (int i = 0; i < count; ++i) {
    Vec3 base = on_lattice_points ? lattice_point(random, 1, 62) : random.point(1, 62);
    base.z() = -4;
    mesh = joined(mesh, tetrahedron(base, base + Vec3(2, 0, 0), base + Vec3(0, 2, 0),
                                    base + Vec3(0.5, 0.5, 10)));
  }
  return mesh;
}

/// Blades through a box, rotated about a common line.
Mesh blades(int count) {
  Mesh mesh = cuboid({-2, -2, -1}, {2, 2, 1});
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * i / count;
    const Vec3 along(3 * std::cos(angle), 3 * std::sin(angle), 0);
    mesh = joined(mesh, tetrahedron(along, -along, {0, 0, 3}, {0, 0, -3.0 - i}));
    mesh = joined(mesh,
                  tetrahedron(along, -along, {0, 0, 2}, Vec3(-along.y() / 50, along.x() / 50, 2)));
  }
  return mesh;
}

void add_touching(Cases& cases) {
  const Mesh unit = cube();
  const std::vector<std::pair<std::string, Vec3>> shifts = {{"vertex", {1, 1, 1}},
                                                            {"edge", {1, 1, 0}},
                                                            {"part-of-edge", {1, 1, 0.5}},
                                                            {"face", {1, 0, 0}},
                                                            {"part-of-face", {1, 0.5, 0.25}},
                                                            {"half-face", {1, 0.5, 0}},
                                                            {"edge-on-face", {1, 0.5, 1}}};
  for (const auto& each : shifts) {
    const auto& name = each.first;
    const Vec3 shift = each.second;
    cases.push_back({"touching", name + "/two", [=] { return joined(unit, moved(unit, shift)); }});
    cases.push_back({"touching", name + "/chain", [=] {
                       Mesh mesh = unit;
                       for (int i = 1; i < 6; ++i) mesh = joined(mesh, moved(unit, i * shift));
                       return mesh;
                     }});
    cases.push_back({"touching", name + "/turned",
                     [=] { return turned(joined(unit, moved(unit, shift))); }, Outcome::clean, 1,
                     true, 1e-16});
    cases.push_back({"touching", name + "/spheres", [=] {
                       const Mesh ball = octahedron(1);
                       return joined(ball, moved(ball, 2 * shift));
                     }});
  }
  for (const double size : {1.0, 0.5})
    cases.push_back({"touching", named("checkerboard", std::lround(2 * size)), [=] {
                       Mesh mesh;
                       for (int i = 0; i < 27; ++i)
                         if ((i + i / 3 + i / 9) % 2 == 0)
                           mesh = joined(mesh,
                                         cuboid(Vec3(i % 3, i / 3 % 3, i / 9),
                                                Vec3(i % 3, i / 3 % 3, i / 9) + Vec3(1, 1, size)));
                       return mesh;
                     }});
}

}  // namespace

void add_contact_cases(Cases& cases) {
  for (const long size : {2, 3, 5, 9})
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
      cases.push_back(
          {"edge-contact",
           named("tetrahedra/size", size) + "/" + named("seed", static_cast<long>(seed)),
           [=] { return lattice_tetrahedra(12, size, seed); }});
  cases.push_back({"edge-contact", "octahedron-in-cube", [] {
                     return joined(cuboid({-1, -1, -1}, {1, 1, 1}), octahedron(2));
                   }});
  cases.push_back({"edge-contact", "octahedron-touches-cube", [] {
                     return joined(cuboid({-1, -1, -1}, {1, 1, 1}), octahedron(1));
                   }});
  cases.push_back({"edge-contact", "octahedron-of-cube-corners", [] {
                     return joined(cuboid({-1, -1, -1}, {1, 1, 1}), octahedron(3));
                   }});
  cases.push_back({"edge-contact", "stella", [] {
                     const Mesh one = tetrahedron({0, 0, 0}, {2, 2, 0}, {2, 0, 2}, {0, 2, 2});
                     return joined(one, moved(stretched(reversed(one), {-1, 1, 1}), {2, 0, 0}));
                   }});
  add_spikes(cases);

  for (const int count : {3, 10, 30, 100}) {
    cases.push_back({"axis", named("star", count), [=] { return star(count, 3); }});
    cases.push_back({"axis", named("fan", count), [=] { return fan(count, false); }});
    cases.push_back(
        {"axis", named("crossing-fan", count), [=] { return fan(std::min(count, 40), true); }});
    cases.push_back({"axis", named("blades", count), [=] { return blades(std::min(count, 40)); }});
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
      cases.push_back({"point",
                       named("burst", count) + "/" + named("seed", static_cast<long>(seed)),
                       [=] { return burst(std::min(count, 40), seed); }});
  }
  for (const int count : {30, 100, 300})
    for (const bool on_lattice_points : {true, false})
      cases.push_back({"many-in-one-face", named(on_lattice_points ? "lattice" : "random", count),
                       [=] { return bed_of_nails(count, on_lattice_points, 5); }});
  add_touching(cases);
}

}  // namespace transformesh::corpus
