/// A surface or a set of points as the reference of a registration: closest points with normals.
#pragma once

#include <optional>
#include <vector>

#include "geometry/search/closest_point.h"
#include "geometry/search/kd_tree.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// A point of a surface with the unit normal there, or zero if there is none.
struct OrientedPoint {
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

/// Points by area with the normals of their faces; of a mesh without faces vertices at even steps
/// of their order, with the columns nx ny nz.
std::vector<OrientedPoint> oriented_samples(const Mesh& mesh, std::size_t count);

class RegistrationSurface {
 public:
  /// Keeps a reference to the mesh. Normals of points are the columns nx ny nz or are estimated.
  explicit RegistrationSurface(const Mesh& mesh);

  struct Partner {
    OrientedPoint point;
    bool is_on_border = false;  ///< the surface ends there
  };
  /// The closest point. Safe to call from several threads at once.
  Partner closest(const Vec3& query) const;

 private:
  bool is_on_border(const Vec3& query, Index face) const;

  const Mesh& mesh_;
  std::optional<ClosestPointQuery> surface_;
  std::vector<bool> border_edges_, border_vertices_;  ///< flags of halfedges and vertices
  std::optional<KdTree> points_;
  std::vector<Vec3> normals_;  ///< one per point
};

}  // namespace transformesh
