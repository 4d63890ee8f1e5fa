/// Finds the nearest place of a target. What that takes is made when it is first asked for and
/// kept, so that an evolution makes it once: hold one for all steps. A Target alone makes one for a
/// call. Keeps a reference to the target, which must not change. The first call of each must not be
/// concurrent. Cost: O(n log n) for the first call, then none.
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

  /// For the faces of a target that is a mesh.
  const ClosestPointQuery& surface() const {
    if (!surface_)
      surface_.emplace(target_->mesh,
                       target_->has_spatial_order ? FaceOrder::spatial : FaceOrder::any);
    return *surface_;
  }
  const KdTree& vertices() const {
    if (!vertices_) vertices_.emplace(target_->mesh.positions);
    return *vertices_;
  }
  /// Of each vertex of a mesh, or each point: unit length or zero.
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
