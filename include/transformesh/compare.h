/// How far a mesh is from a reference, both ways. Points are taken evenly over each surface
/// (stratified by area, so that many draws even out quickly), plus every vertex; each is measured
/// to the closest point of the other surface. A mesh without faces stands for its vertices.
///
/// Means and shares are over the points taken by area. The Hausdorff distances are maxima over
/// points by area and vertices: never above the true ones, and below by no more than the coarseness
/// of the points. Deterministic in mesh, options and seed, for any number of threads.
/// Cost: O(samples log n). Reference: Cignoni, Rocchini & Scopigno, "Metro: measuring error on
/// simplified surfaces", Computer Graphics Forum 17(2), 1998.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {
class ClosestPointQuery;

struct CompareOptions {
  std::size_t samples = 100000;  ///< points by area on each surface; with 0 the vertices alone
  std::uint64_t seed = 1;
  /// What counts as reached by `completeness`, in input units; negative: 1 % of the diagonal of the
  /// reference's box.
  double distance = -1;
};

struct Comparison {
  double accuracy = 0;      ///< 90 % of the mesh are no farther from the reference
  double completeness = 0;  ///< share of the reference no farther from the mesh than `distance`
  double mean = 0;          ///< of the two mean distances, there and back
  double rms = 0;           ///< root of the mean of the two mean squared distances
  double hausdorff = 0;     ///< the larger of the following two
  double hausdorff_to_reference = 0;    ///< largest distance from the mesh to the reference
  double hausdorff_from_reference = 0;  ///< largest distance from the reference to the mesh
  double volume_difference = 0;         ///< of the mesh minus that of the reference
};

/// Throws InputError where one of them has no vertices, or distances are beyond about 1e154.
Comparison compare(const Mesh& mesh, const Mesh& reference, const CompareOptions& options = {},
                   const Progress& progress = {});

/// Distances of all vertices from the faces of the reference, or from its vertices if it has none.
/// Signed ones are negative inside; they need faces. Throw what compare() throws. O(n log n).
std::vector<double> vertex_distances(const Mesh& mesh, const Mesh& reference,
                                     const Progress& progress = {});
std::vector<double> signed_vertex_distances(const Mesh& mesh, const Mesh& reference,
                                            const Progress& progress = {});

/// One way of a Hausdorff distance: how far away the farthest point is, and where.
struct Farthest {
  double distance = 0;
  Vec3 point = Vec3::Zero();
};
/// The farthest of the same points from the faces of another mesh; much faster than compare().
Farthest farthest_from(const ClosestPointQuery& reference, const Mesh& mesh,
                       const CompareOptions& options = {});

}  // namespace transformesh
