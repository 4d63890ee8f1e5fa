/// Kinds of damage that occur in files, applied to solids: inputs for repair() with known results.
/// Shares only the mesh type with the library. Deterministic for a seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::corpus {

struct Damage {
  std::string name;
  Mesh (*apply)(const Mesh& solid, std::uint64_t seed);
  /// Volume of the correct result as a multiple of the solid's volume; 0 if the damage does not
  /// determine it.
  double volume = 1;
};

const std::vector<Damage>& damages();

struct Solid {
  std::string name;
  Mesh mesh;
  double volume;  ///< volume of `mesh` by the divergence theorem
};

/// Returns a cube, a sphere, a torus, an angle bracket and a hollow ball.
std::vector<Solid> solids();

/// Returns why the repaired mesh is not the expected solid; empty if it is. A `volume` of 0 accepts
/// any solid. Topology is counted, and CGAL finds intersections.
std::string fault_of(const Mesh& repaired, double volume);

}  // namespace transformesh::corpus
