// Open sheets: intersecting, wavy, folded through themselves, with holes.
#include "corpus/build.h"
#include "corpus/cases.h"

namespace transformesh::corpus {
namespace {

Mesh wavy(int cells, double height) {
  Mesh mesh = grid(cells);
  for (Vec3& p : mesh.positions) p.z() = height * std::sin(9 * p.x()) * std::cos(7 * p.y());
  return mesh;
}

/// The upper part of a sphere, with its rim pulled through its bottom.
Mesh bowl(int size, double pull) {
  const Mesh ball = icosphere(size);
  Mesh mesh = ball;
  mesh.faces.clear();
  for (const Face& face : ball.faces)
    if (ball.positions[face[0]].z() + ball.positions[face[1]].z() + ball.positions[face[2]].z() >
        0.6)
      mesh.faces.push_back(face);
  for (Vec3& p : mesh.positions)
    if (p.z() < 0.5) p = Vec3(0.6 * p.x(), 0.6 * p.y(), p.z() + pull);
  return mesh;
}

/// Returns the mesh without some of its faces.
Mesh with_holes(const Mesh& mesh, int holes, std::uint64_t seed) {
  Random random(seed);
  Mesh result = mesh;
  while (holes-- > 0)
    result.faces.erase(result.faces.begin() +
                       static_cast<std::ptrdiff_t>(random.below(result.faces.size())));
  return result;
}

Mesh upright(Mesh mesh) {
  for (Vec3& p : mesh.positions) p = Vec3(p.z() + 0.5, p.x(), p.y() - 0.4);
  return mesh;
}

}  // namespace

void add_open_cases(Cases& cases) {
  const Mesh balls = joined(icosphere(2), moved(icosphere(2), {0.7, 0.3, 0.2}));
  for (const int cells : {1, 4, 9}) {
    const std::string name = named("cells", cells);
    cases.push_back({"open", "sheet/" + name, [=] { return grid(cells); }});
    cases.push_back({"open", "wavy/" + name, [=] { return wavy(cells, 0.2); }});
    cases.push_back(
        {"open", "crossing/" + name, [=] { return joined(grid(cells), upright(grid(cells))); }});
    cases.push_back({"open", "crossing-wavy/" + name,
                     [=] { return joined(wavy(cells, 0.1), upright(wavy(cells, 0.05))); }});
  }
  for (const double pull : {0.0, 0.3, 0.6})
    cases.push_back({"open", named("bowl", std::lround(10 * pull)), [=] { return bowl(3, pull); }});
  for (const int holes : {1, 4, 12})
    cases.push_back({"open", named("holes", holes), [=] { return with_holes(balls, holes, 4); }});
}

}  // namespace transformesh::corpus
