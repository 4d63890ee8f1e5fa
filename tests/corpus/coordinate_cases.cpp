// Coordinates at the limits: nearly coplanar faces, needles, tiny and huge meshes, meshes far from
// the origin, and shapes that the spacing of floats or doubles barely resolves.
#include "corpus/build.h"
#include "corpus/cases.h"

namespace transformesh::corpus {
namespace {

/// Intersecting bodies of several kinds, in or slightly larger than the unit box.
std::vector<std::pair<std::string, Mesh>> bodies() {
  Random random(11);
  Mesh boxes;
  for (int i = 0; i < 5; ++i) boxes = joined(boxes, scaled(lattice_box(random, 6, 4), 0.25));
  Mesh tetrahedra;
  for (int i = 0; i < 6; ++i)
    tetrahedra = joined(tetrahedra, scaled(lattice_tetrahedron(random, -4, 4), 0.25));
  return {{"balls", joined(icosphere(2), moved(icosphere(2), {0.7, 0.3, 0.2}))},
          {"ring", joined(torus(1, 0.4, 24, 12), turned(torus(1, 0.4, 24, 12), 1.1))},
          {"boxes", boxes},
          {"tetrahedra", tetrahedra}};
}

/// A box, and a copy that is tilted and shifted by tiny amounts.
Mesh tilted_pair(double by) {
  const Mesh box = cuboid({0, 0, 0}, {1, 1, 1});
  Mesh other = moved(box, {0.3, 0.2, by});
  for (Vec3& p : other.positions) p.z() += by * (p.x() - 2 * p.y());
  return joined(box, other);
}

/// Nearly equal spheres.
Mesh near_copies(int count, double by) {
  Random random(3);
  Mesh mesh;
  for (int i = 0; i < count; ++i) mesh = joined(mesh, moved(icosphere(1), random.point(-by, by)));
  return mesh;
}

/// A cone of many needles through a box.
Mesh needle_cone(int sides) {
  return joined(moved(bipyramid(sides, 0.05, 2, 0.1), {0.01, 0.02, 0}),
                cuboid({-1, -1, -0.5}, {1, 1, 0.5}));
}

/// Two balls with corners on the integer lattice, at the given distance from the origin. At 2^23
/// for floats and 2^52 for doubles, there is no number between neighboring lattice points.
Mesh barely(double radius, double offset) {
  const Mesh ball = on_lattice(scaled(icosphere(radius > 20 ? 2 : 1), radius));
  const Vec3 shift = Vec3(0.7, 0.3, 0.4) * radius;
  const Mesh other = on_lattice(moved(scaled(turned(icosphere(1)), radius), shift));
  return moved(joined(ball, other), Vec3::Constant(offset));
}

void add_nearly_coplanar(Cases& cases) {
  for (int exponent = 4; exponent <= 16; exponent += 2) {
    const double by = std::pow(10.0, -exponent);
    const std::string name = "distance-1e-" + std::to_string(exponent);
    cases.push_back({"nearly-coplanar", "tilted/" + name, [=] { return tilted_pair(by); },
                     Outcome::clean, 1, true, by});
    cases.push_back({"nearly-coplanar", "tilted-turned/" + name,
                     [=] { return turned(tilted_pair(by)); }, Outcome::clean, 1, true, by});
    cases.push_back({"nearly-coplanar", "minus/" + name,
                     [=] {
                       const Mesh box = cuboid({0, 0, 0}, {1, 1, 1});
                       return joined(box, reversed(moved(scaled(box, 0.5), {0.2, 0.3, 0.5 - by})));
                     },
                     Outcome::clean, 1, true, by});
    for (const int count : {2, 4})
      cases.push_back({"nearly-coplanar", named("copies", count) + "/" + name,
                       [=] { return near_copies(count, by); }, Outcome::clean, 1, true, by});
  }
}

void add_needles(Cases& cases) {
  for (const double thin : {1e-2, 1e-4, 1e-6})
    for (const auto& [shape, mesh] : bodies()) {
      const std::string name =
          shape + "/" + "thinness-1e" + std::to_string(std::lround(std::log10(thin)));
      cases.push_back({"needles", name,
                       [=, mesh = mesh] {
                         return stretched(mesh, {1, thin, thin});
                       },
                       Outcome::clean, 1, true, thin / 10});
      cases.push_back({"needles", name + "/plate",
                       [=, mesh = mesh] {
                         return stretched(mesh, {1, 1, thin});
                       },
                       Outcome::clean, 1, true, thin / 10});
      cases.push_back({"needles", name + "/turned",
                       [=, mesh = mesh] {
                         return turned(stretched(mesh, {1, thin, thin}));
                       },
                       Outcome::clean, 1, true, thin / 10});
    }
  for (const int sides : {10, 100, 500})
    cases.push_back({"needles", named("cone", sides), [=] { return needle_cone(sides); }});
}

void add_scales(Cases& cases) {
  for (const auto& [shape, mesh] : bodies()) {
    for (const int exponent : {-30, 30})
      cases.push_back({"scale", shape + "/1e" + std::to_string(exponent),
                       [=, mesh = mesh] { return scaled(mesh, std::pow(10.0, exponent)); }});
    for (const int exponent : {-300, -150, -60, 60, 150, 300})
      cases.push_back({"scale", shape + "/1e" + std::to_string(exponent),
                       [=, mesh = mesh] { return scaled(mesh, std::pow(10.0, exponent)); },
                       Outcome::clean, 1, false});
    cases.push_back({"far-away", shape + "/1e6-features-1e-3",
                     [=, mesh = mesh] {
                       return moved(scaled(mesh, 1e-3), {1e6, -1e6, 1e6});
                     },
                     Outcome::clean, 1, false});
    cases.push_back({"far-away", shape + "/1e6-along-x",
                     [=, mesh = mesh] {
                       return moved(scaled(mesh, 1e-3), {1e6, 0, 0});
                     },
                     Outcome::clean, 1, false});
    cases.push_back({"far-away", shape + "/1e9",
                     [=, mesh = mesh] {
                       return moved(mesh, {1e9, 1e9, 1e9});
                     },
                     Outcome::clean, 1, false});
    cases.push_back({"far-away", shape + "/1e3-features-1", [=, mesh = mesh] {
                       return moved(mesh, {1e3, 2e3, -1e3});
                     }});
  }
}

}  // namespace

void add_coordinate_cases(Cases& cases) {
  add_nearly_coplanar(cases);
  add_needles(cases);
  add_scales(cases);
  for (const double radius : {4.0, 8.0, 16.0, 32.0, 128.0, 1000.0}) {
    const std::string name = named("radius", std::lround(radius));
    cases.push_back({"barely-held", name + "/float", [=] { return barely(radius, 0x1p23); },
                     Outcome::clean, 1, true, 0x1p-23});
    cases.push_back({"barely-held", name + "/double", [=] { return barely(radius, 0x1p52); },
                     Outcome::clean, 1, false, 0x1p-52});
    cases.push_back({"barely-held", name + "/origin", [=] { return barely(radius, 0); }});
  }
}

}  // namespace transformesh::corpus
