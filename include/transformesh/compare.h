/// Distances between a mesh and a reference, both ways, from sample points that are uniform by area
/// and from every vertex. A mesh without faces stands for its vertices.
///
/// Means and fractions are over the sample points. The Hausdorff distances are maxima over sample
/// points and vertices. They never exceed the true distances, and fall short by at most the spacing
/// of the points. Deterministic in mesh, options and seed, for any number of threads. Cost:
/// O(samples log n). Reference: Cignoni, Rocchini & Scopigno, "Metro: measuring error on simplified
/// surfaces", Computer Graphics Forum 17(2), 1998.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {
class ClosestPointQuery;

struct CompareOptions {
  std::size_t samples = 100000;  ///< sample points on each surface; 0: vertices only
  std::uint64_t seed = 1;
  /// Distance up to which `completeness` counts a point as reached, in input units. Negative: 1 %
  /// of the diagonal of the reference's bounding box.
  double distance = -1;
};

struct Comparison {
  double accuracy = 0;      ///< 90th percentile of the distances from the mesh to the reference
  double completeness = 0;  ///< fraction of the reference within `distance` of the mesh; [0, 1]
  double mean = 0;          ///< mean of the mean distances in both directions
  double rms = 0;           ///< root of the mean of the mean squared distances in both directions
  double hausdorff = 0;     ///< larger of the following two distances
  double hausdorff_to_reference = 0;    ///< largest distance from the mesh to the reference
  double hausdorff_from_reference = 0;  ///< largest distance from the reference to the mesh
  double volume_difference = 0;         ///< volume of the mesh minus that of the reference
};

/// Throws InputError if a mesh has no vertices or both together extend over 1e75 or more.
Comparison compare(const Mesh& mesh, const Mesh& reference, const CompareOptions& options = {},
                   const Progress& progress = {});

/// Return the distances of vertices from the faces of the reference, or if it has none, from its
/// vertices. Signs (negative inside) need joined faces (stitch.h), not inside out. Throw as above.
std::vector<double> vertex_distances(const Mesh& mesh, const Mesh& reference,
                                     const Progress& progress = {});
std::vector<double> signed_vertex_distances(const Mesh& mesh, const Mesh& reference,
                                            const Progress& progress = {});

/// One-sided Hausdorff distance: the farthest point and its distance.
struct Farthest {
  double distance = 0;
  Vec3 point = Vec3::Zero();
};
/// Returns the sample or vertex of `mesh` farthest from the reference's faces. Faster than
/// compare().
Farthest farthest_from(const ClosestPointQuery& reference, const Mesh& mesh,
                       const CompareOptions& options = {});

}  // namespace transformesh
