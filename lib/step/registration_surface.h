/// The reference of a registration, a surface or a point set: finds closest points with normals.
#pragma once

#include <optional>
#include <vector>

#include "geometry/search/closest_point.h"
#include "geometry/search/kd_tree.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// A point of a surface with its unit normal; the normal is zero if it is unknown.
struct OrientedPoint {
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

/// Returns `count` random points, uniform by area, with the normals of their faces. For a mesh
/// without faces, returns at most `count` vertices at equal steps of their order, with the normals
/// in the columns nx, ny and nz.
std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, std::size_t count);

class RegistrationSurface {
 public:
  /// Keeps a reference to the mesh. If the mesh has no faces, normals are the columns nx, ny and
  /// nz, or else are estimated.
  explicit RegistrationSurface(const Mesh& mesh);

  struct Partner {
    OrientedPoint point;
    bool is_on_border = false;  ///< the closest point lies on a border of the surface
  };
  /// Returns the closest point. Thread-safe.
  Partner closest(const Vec3& query) const;

 private:
  bool is_on_border(const Vec3& query, Index face) const;

  const Mesh& mesh_;
  std::optional<ClosestPointQuery> surface_;
  /// One flag per halfedge and one flag per vertex: true if it lies on a border of the surface.
  std::vector<bool> border_edges_, border_vertices_;
  std::optional<KdTree> points_;
  std::vector<Vec3> normals_;  ///< normal of each point
};

}  // namespace transformesh
