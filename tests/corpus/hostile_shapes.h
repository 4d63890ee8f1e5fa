/// Families of tiny closed oriented meshes that are made to break rounding: many faces through one
/// place, parts a few spacings of numbers thick, coordinates of very different magnitudes. A seed
/// gives a mesh of fewer than 700 faces.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::corpus {

struct HostileFamily {
  std::string name;
  /// Spacings and magnitudes are those of the scalar type; the mesh is rounded to it.
  Mesh (*make)(std::uint64_t seed, Scalar type);
};

const std::vector<HostileFamily>& hostile_families();

/// A mesh of a family, with its coordinates rounded to the type.
Mesh hostile_mesh(const HostileFamily& family, std::uint64_t seed, Scalar type);

}  // namespace transformesh::corpus
