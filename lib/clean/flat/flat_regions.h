/// Flat regions of a mesh: connected faces whose corners all lie near one plane.
///
/// A region grows from the largest faces first, across edges, as long as corners are within the
/// tolerance of its plane. Then the plane is fitted to all of its corners, and it grows on. So a
/// region may be many times as large as the face where it began. Faces that are higher than the
/// tolerance look to the same side. Faces whose columns differ are in different regions.
/// Deterministic. Cost: O(n log n) for n faces in and around the regions.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct FlatRegion {
  Vec3 point = Vec3::Zero();  ///< on the plane
  Vec3 normal = Vec3::Zero();
  double low = 0, high = 0;  ///< distances of its corners from the plane
  std::vector<Index> faces;
};

struct FlatRegions {
  std::vector<FlatRegion> regions;  ///< each has two faces at least
  std::vector<Index> of_face;       ///< per face its region, or no_index
};

/// Finds the regions that hold a face marked in `wanted`. `opposites` are those of a manifold.
/// Corners are within `spacings` of the numbers of type `coordinate` from the plane.
FlatRegions find_flat_regions(const Mesh& mesh, std::span<const Index> opposites,
                              std::span<const char> wanted, double spacings, Scalar coordinate);

}  // namespace transformesh
