/// Flat regions of a mesh: connected faces whose corners are all close to one plane.
///
/// The first face of a region defines a plane; large faces are tried first. The region grows across
/// edges, as long as corners are within the tolerance of the plane. Then the plane is fitted to all
/// corners of the region, and the region grows further. Hence a region may be many times as large
/// as its first face. A face whose least height exceeds twice the tolerance must have its front on
/// the same side as the first face. Faces with different column values belong to different regions.
/// Deterministic. Cost: O(n log n) for n faces in and around the regions.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct FlatRegion {
  Vec3 point = Vec3::Zero();  ///< a point on the plane of the region
  Vec3 normal = Vec3::Zero();
  double low = 0, high = 0;  ///< range of the signed distances of the corners from the plane
  std::vector<Index> faces;
};

struct FlatRegions {
  std::vector<FlatRegion> regions;  ///< the regions, each of at least two faces
  std::vector<Index> of_face;       ///< region of each face, or no_index
};

/// Finds the regions that contain a face with a nonzero `wanted` entry. `opposites` are the
/// opposite halfedges of `mesh`, a manifold. `spacings` is the tolerance: the largest distance of
/// corners from the plane, divided by the spacing of numbers of type `coordinate` at the first
/// face.
FlatRegions find_flat_regions(const Mesh& mesh, std::span<const Index> opposites,
                              std::span<const char> wanted, double spacings, Scalar coordinate);

}  // namespace transformesh
