/// The search structures of a target: a closest-point search, a kd-tree of vertices, and normals.
/// Each of them is built when its function is first called, and is then kept. For all steps of an
/// evolution, construct one query and reuse it. For a single call, pass the Target itself, which
/// converts implicitly to a query. Keeps a reference to the target, which must not change. The
/// first call of each function must not be concurrent with others. Cost: O(n log n) for the first
/// call, then O(1).
#pragma once

#include <optional>
#include <vector>

#include "geometry/search/closest_point.h"
#include "geometry/search/kd_tree.h"
#include "transformesh/measure.h"
#include "transformesh/target.h"

namespace transformesh {

class TargetQuery {
 public:
  TargetQuery(const Target& target) : target_(&target) {}
  const Target& target() const { return *target_; }

  /// Returns the search for closest points on the faces. The target must be a mesh.
  const ClosestPointQuery& surface() const {
    if (!surface_)
      surface_.emplace(target_->mesh,
                       target_->has_spatial_order ? FaceOrder::spatial : FaceOrder::any);
    return *surface_;
  }
  /// Returns the search for nearest vertices, or for nearest points of a point set.
  const KdTree& vertices() const {
    if (!vertices_) vertices_.emplace(target_->mesh.positions);
    return *vertices_;
  }
  /// Returns the normals of the vertices, or of the points of a point set. They have unit length or
  /// are zero.
  const std::vector<Vec3>& normals() const {
    if (!target_->is_mesh()) return target_->normals;
    if (normals_.empty()) normals_ = vertex_normals(target_->mesh);
    return normals_;
  }

 private:
  const Target* target_;
  mutable std::optional<ClosestPointQuery> surface_;
  mutable std::optional<KdTree> vertices_;
  mutable std::vector<Vec3> normals_;
};

}  // namespace transformesh
