/// Kinds of damage that files have, done to solids: inputs for repair() with known results. Shares
/// nothing with the library but the mesh. Deterministic for a seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::corpus {

struct Damage {
  std::string name;
  Mesh (*apply)(const Mesh& solid, std::uint64_t seed);
  /// Volume of the right result as a multiple of the solid's; 0 if the damage does not determine
  /// it.
  double volume = 1;
};

const std::vector<Damage>& damages();

struct Solid {
  std::string name;
  Mesh mesh;
  double volume;  ///< by the divergence theorem
};

/// A cube, a sphere, a torus, an angle bracket and a hollow ball.
std::vector<Solid> solids();

/// Why the repaired mesh is not the solid that it should be; empty if it is. `volume` is 0 if only
/// a solid is asked for. Topology is counted, intersections are found by CGAL.
std::string fault_of(const Mesh& repaired, double volume);

}  // namespace transformesh::corpus
