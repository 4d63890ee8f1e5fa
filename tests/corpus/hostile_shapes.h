/// Families of tiny closed oriented meshes that stress rounding: many faces through one point,
/// parts only a few spacings thick, coordinates of very different magnitudes. Each seed gives a
/// mesh of fewer than 700 faces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::corpus {

struct HostileFamily {
  std::string name;
  /// Spacings and magnitudes are those of the scalar type, to which the mesh is rounded.
  Mesh (*make)(std::uint64_t seed, Scalar type);
};

const std::vector<HostileFamily>& hostile_families();

/// Returns a mesh of a family, with coordinates rounded to the type.
Mesh hostile_mesh(const HostileFamily& family, std::uint64_t seed, Scalar type);

}  // namespace transformesh::corpus
