// Closed surfaces whose vertices are random points of a coarse lattice, jittered, or partly on the
// way to the surface inside out.
#include "corpus/build.h"
#include "corpus/cases.h"

namespace transformesh::corpus {
namespace {

/// Returns the faces of the mesh with random vertices on a lattice. Many faces coincide, fold, lose
/// their area or pass through corners of others.
Mesh thrown(Mesh mesh, long size, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& position : mesh.positions) position = lattice_point(random, 0, size);
  return mesh;
}

/// Returns a surface on the straight path from the unit sphere to its point reflection, with bulges
/// and a twist.
Mesh everting(int size, double time) {
  Mesh mesh = icosphere(size);
  for (Vec3& p : mesh.positions) {
    const double angle = std::atan2(p.y(), p.x());
    const double bulge = time * (1 - time) * std::cos(3 * angle) * (1 - p.z() * p.z());
    const Eigen::AngleAxisd twist(2 * time * p.z(), Vec3::UnitZ());
    p = twist * Vec3((1 - 1.6 * time) * p.x() + bulge, (1 - 1.6 * time) * p.y(),
                     (1 - 1.9 * time * std::abs(p.z())) * p.z());
  }
  return mesh;
}

}  // namespace

void add_random_cases(Cases& cases) {
  const std::vector<std::pair<std::string, Mesh>> surfaces = {{"tetrahedron", test::tetrahedron()},
                                                              {"ball-0", icosphere(0)},
                                                              {"ball-1", icosphere(1)},
                                                              {"ring", torus(1, 0.4, 9, 5)}};
  for (const auto& [shape, mesh] : surfaces)
    for (const long size : {1, 2, 3, 5, 100})
      for (std::uint64_t seed = 1; seed <= 3; ++seed)
        cases.push_back(
            {"lattice-soup",
             shape + "/" + named("size", size) + "/" + named("seed", static_cast<long>(seed)),
             [=, mesh = mesh] { return thrown(mesh, size, seed); }, Outcome::by_winding});

  for (const int percent : {5, 20, 50, 150})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const std::string name =
          named("percent", percent) + "/" + named("seed", static_cast<long>(seed));
      cases.push_back({"jitter", "ball/" + name,
                       [=] {
                         Random random(seed);
                         return jittered(icosphere(3), 0.15 * percent / 100, random);
                       },
                       Outcome::by_winding});
      cases.push_back({"jitter", "ring/" + name,
                       [=] {
                         Random random(seed);
                         return jittered(torus(1, 0.4, 30, 12), 0.2 * percent / 100, random);
                       },
                       Outcome::by_winding});
    }

  for (int step = 1; step <= 9; ++step)
    for (const int size : {2, 3, 4})
      cases.push_back({"eversion", named("size", size) + "/" + named("step", step),
                       [=] { return everting(size, step / 10.0); }, Outcome::by_winding});
}

}  // namespace transformesh::corpus
