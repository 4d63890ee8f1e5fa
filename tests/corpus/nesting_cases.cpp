// Nested and inverted components, cavities, winding numbers from -3 to 5, and inputs that must be
// refused: meshes that are inside out or not oriented.
#include "corpus/build.h"
#include "corpus/cases.h"

namespace transformesh::corpus {
namespace {

/// Nested shells; a minus in `signs` turns its shell inside out.
Mesh shells(const std::string& signs, bool boxes) {
  Mesh mesh;
  double radius = 1;
  for (const char sign : signs) {
    const Mesh ball =
        boxes ? scaled(cuboid({-1, -1, -1}, {1, 1, 1}), radius) : scaled(icosphere(1), radius);
    mesh = joined(mesh, sign == '+' ? ball : reversed(ball));
    radius *= 0.7;
  }
  return mesh;
}

/// Random boxes of which `inverted` are inside out, so that winding numbers begin at -inverted.
Mesh signed_boxes(int count, int inverted, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Mesh box = lattice_box(random, 7, 5);
    mesh = joined(mesh, i < inverted ? reversed(box) : box);
  }
  return mesh;
}

/// `copies` balls in general position that all contain the origin, `inverted` of them inside out.
Mesh signed_balls(int copies, int inverted, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < copies; ++i) {
    const Mesh ball = moved(turned(icosphere(1), 0.3 * i), random.point(-0.5, 0.5));
    mesh = joined(mesh, i < inverted ? reversed(ball) : ball);
  }
  return mesh;
}

void add_cavities(Cases& cases) {
  const std::vector<std::pair<std::string, Mesh>> holes = {
      {"inside", cuboid({1, 1, 1}, {3, 3, 3})},
      {"on-face", cuboid({1, 1, 1}, {3, 3, 4})},
      {"on-edge", cuboid({1, 1, 1}, {3, 4, 4})},
      {"in-corner", cuboid({2, 2, 2}, {4, 4, 4})},
      {"through", cuboid({1, 1, -1}, {3, 3, 5})},
      {"flush-through", cuboid({1, 1, 0}, {3, 3, 4})},
      {"larger", cuboid({-1, -1, 1}, {5, 5, 3})},
      {"poking-out", cuboid({3, 1, 1}, {5, 3, 3})},
      {"slot", cuboid({0, 1, 1}, {4, 2, 4})},
      {"tip-on-face", tetrahedron({2, 2, 4}, {1, 1, 1}, {3, 1, 1}, {2, 3, 1})}};
  const Mesh body = cuboid({0, 0, 0}, {4, 4, 4});
  for (const auto& [name, hole] : holes) {
    cases.push_back({"cavity", name, [=, hole = hole] { return joined(body, reversed(hole)); }});
    cases.push_back({"cavity", name + "/turned",
                     [=, hole = hole] { return turned(joined(body, reversed(hole))); },
                     Outcome::clean, 1, true, 1e-16});
    cases.push_back({"cavity", name + "/twice",
                     [=, hole = hole] { return joined(joined(body, body), reversed(hole)); }});
  }
}

Mesh with_flipped_faces(Mesh mesh, int count, std::uint64_t seed) {
  Random random(seed);
  while (count-- > 0) {
    Face& face = mesh.faces[random.below(mesh.faces.size())];
    std::swap(face[0], face[1]);
  }
  return mesh;
}

void add_signed_bodies(Cases& cases) {
  for (const int inverted : {1, 2, 3})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const std::string name =
          named("inverted", inverted) + "/" + named("seed", static_cast<long>(seed));
      cases.push_back({"inverted", name + "/boxes", [=] { return signed_boxes(6, inverted, seed); },
                       Outcome::by_winding});
      cases.push_back({"inverted", name + "/balls",
                       [=] { return signed_balls(inverted + 3, inverted, seed); },
                       Outcome::by_winding});
    }

  for (int winding_level = 1; winding_level <= 5; ++winding_level)
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const std::string name =
          named("level", winding_level) + "/" + named("seed", static_cast<long>(seed));
      cases.push_back({"levels", name + "/boxes", [=] { return signed_boxes(12, 0, seed); },
                       Outcome::by_winding, winding_level});
      cases.push_back({"levels", name + "/signed", [=] { return signed_boxes(16, 3, seed); },
                       Outcome::by_winding, winding_level});
      cases.push_back({"levels", name + "/balls", [=] { return signed_balls(8, 3, seed); },
                       Outcome::by_winding, winding_level});
    }
}

void add_wrongly_oriented(Cases& cases) {
  for (int size = 0; size <= 3; ++size) {
    const std::string name = named("ball", size);
    cases.push_back(
        {"inside-out", name, [=] { return reversed(icosphere(size)); }, Outcome::inside_out});
    cases.push_back({"inside-out", name + "/crossing",
                     [=] {
                       return reversed(joined(icosphere(size), moved(icosphere(size), {1, 0, 0})));
                     },
                     Outcome::inside_out});
    cases.push_back({"not-oriented", name,
                     [=] { return with_flipped_faces(icosphere(size), 1, 5); },
                     Outcome::not_oriented});
    cases.push_back({"not-oriented", name + "/crossing",
                     [=] {
                       return with_flipped_faces(
                           joined(icosphere(size), moved(icosphere(size), {1, 0.1, 0})), 1, 6);
                     },
                     Outcome::not_oriented});
  }
}

}  // namespace

void add_nesting_cases(Cases& cases) {
  for (const std::string signs :
       {"++", "+++++", "+-", "+-+", "+-+-+", "+--+++", "-+", "-++", "++--++", "---++++++"})
    for (const bool boxes : {false, true}) {
      const std::string name = signs + (boxes ? "/boxes" : "/balls");
      cases.push_back({"nested", name, [=] { return shells(signs, boxes); },
                       signs == "-+" ? Outcome::inside_out : Outcome::clean});
    }
  add_signed_bodies(cases);
  add_cavities(cases);
  add_wrongly_oriented(cases);
}

}  // namespace transformesh::corpus
