#include "clean/exterior/ray_cast_front_winding.h"

#include <cmath>
#include <limits>
#include <string>

#include "mesh/disjoint_sets.h"
#include "mesh/location_text.h"
#include "support/error.h"

namespace transformesh {
namespace {

constexpr int most_attempts = 20000;  // whose squares fit into an int
constexpr std::size_t few_rays = 8;

Bvh build_bvh(const WeldedMesh& welded, const std::vector<Triangle>& closure) {
  std::vector<FloatBox> boxes;
  boxes.reserve(welded.faces.size() + closure.size());
  for (Index f = 0; f < welded.faces.size(); ++f) boxes.push_back(welded.box(f));
  for (const Triangle& t : closure) boxes.push_back(welded.box(t));
  return Bvh(boxes);
}

/// On which side of edges a point lies in a projection, as far as doubles tell: 0 where they do
/// not.
class SideFilter {
 public:
  SideFilter(const ExactPoint& point, PlaneProjection p)
      : p_(p),
        u_(point.center[p.u]),
        v_(point.center[p.v]),
        radius_u_(point.radius[p.u]),
        radius_v_(point.radius[p.v]) {}

  int side_of(const Vec3& a, const Vec3& b) const {
    const double along_u = b[p_.u] - a[p_.u], along_v = b[p_.v] - a[p_.v];
    const double left = along_u * (v_ - a[p_.v]), right = along_v * (u_ - a[p_.u]);
    const double error =
        rounding * (std::abs(left) + std::abs(right)) +
        (1 + rounding) * (std::abs(along_u) * radius_v_ + std::abs(along_v) * radius_u_) +
        underflow_guard;
    const double turn = left - right;
    return turn > error ? 1 : turn < -error ? -1 : 0;
  }

 private:
  static constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  static constexpr double underflow_guard = 1e-280;

  PlaneProjection p_;
  double u_, v_, radius_u_, radius_v_;
};

// The weights of a point inside a triangle, another one for each attempt. The first is its
// centroid, and all lie on a conic.
std::array<int, 3> weights(int attempt) { return {1, attempt, attempt * attempt}; }

}  // namespace

RayCastFrontWinding::RayCastFrontWinding(const Arrangement& arrangement,
                                         const BorderClosure& closure, std::size_t rays)
    : welded_(*arrangement.welded), arrangement_(&arrangement), closure_(closure.triangles) {
  if (rays > few_rays) bvh_ = build_bvh(welded_, closure_);
  if (!closure.empty()) limit_sheets(closure);
}

RayCastFrontWinding::RayCastFrontWinding(const WeldedMesh& welded, std::size_t rays,
                                         const Surroundings* around)
    : welded_(welded), around_(around) {
  if (rays > few_rays) bvh_ = build_bvh(welded_, closure_);
}

Triangle RayCastFrontWinding::triangle(Index i) const {
  const std::size_t faces = welded_.faces.size();
  return i < faces ? welded_.triangle(i) : closure_[i - faces];
}

void RayCastFrontWinding::visit_overlaps(const Vec3& low, const Vec3& high,
                                         const std::function<bool(Index)>& visit) const {
  if (!bvh_.empty()) return bvh_.visit_overlaps(welded_.frame.box(low, high), visit);
  const auto count = static_cast<Index>(welded_.faces.size() + closure_.size());
  for (Index i = 0; i < count; ++i) {
    const Triangle t = triangle(i);
    if ((t[0].cwiseMin(t[1]).cwiseMin(t[2]).array() <= high.array()).all() &&
        (t[0].cwiseMax(t[1]).cwiseMax(t[2]).array() >= low.array()).all() && !visit(i))
      return;
  }
}

// A sheet counts only for pieces of its own component, as it bounds nothing but what it meets.
void RayCastFrontWinding::limit_sheets(const BorderClosure& closure) {
  DisjointSets sets(arrangement_->point_count());
  for (const Piece& piece : arrangement_->pieces) {
    sets.join(piece.corners[0], piece.corners[1]);
    sets.join(piece.corners[0], piece.corners[2]);
  }
  component_of_.resize(arrangement_->point_count());
  for (Index p = 0; p < component_of_.size(); ++p) component_of_[p] = sets.find(p);

  const auto limit = [&](Index face) {
    const Index point = welded_.faces[face][0];
    only_for_.push_back(closure.in_sheet[face] ? component_of_[point] : no_index);
  };
  for (Index f = 0; f < welded_.faces.size(); ++f) limit(f);
  for (const Index face : closure.face_of) limit(face);
}

int RayCastFrontWinding::in_front_of(const Piece& piece) const {
  const Index component = component_of_.empty() ? no_index : component_of_[piece.corners[0]];
  const auto& [a, b, c] = piece.corners;
  return in_front_of({arrangement_->point(a), arrangement_->point(b), arrangement_->point(c)},
                     arrangement_->sources_of(piece).front(), component);
}

int RayCastFrontWinding::in_front_of(const std::array<ExactPoint, 3>& part, Index face) const {
  return in_front_of(part, {face, false}, no_index);
}

std::optional<int> RayCastFrontWinding::in_front_of(const ExactPoint& point, Index face) const {
  const auto [axis, direction] = axis_and_direction({face, false});
  const Count count = cast(point, axis, direction, no_index);
  return count.grazes ? std::nullopt : std::optional(count.winding);
}

// A ray runs to the front, along the axis that is nearest to the normal.
std::pair<int, int> RayCastFrontWinding::axis_and_direction(const PieceSource& source) const {
  const PlaneProjection projection = projection_of(welded_.triangle(source.face));
  const bool even = projection.v == (projection.u + 1) % 3;
  return {3 - projection.u - projection.v, even != source.reversed ? 1 : -1};
}

int RayCastFrontWinding::in_front_of(const std::array<ExactPoint, 3>& part,
                                     const PieceSource& source, Index component) const {
  const auto [axis, direction] = axis_and_direction(source);
  const ExactGeometry geometry(welded_.points, welded_.faces);
  // A ray grazes an edge where its origin lies on the projection of that edge to the piece: a
  // segment, which has at most two points on the conic. So every edge spoils at most two attempts.
  for (int attempt = 1; attempt <= most_attempts; ++attempt) {
    const ExactPoint origin = geometry.mean(part[0], part[1], part[2], weights(attempt));
    const Count count = cast(origin, axis, direction, component);
    if (!count.grazes) return count.winding;
  }
  throw GoalError("more than " + std::to_string(most_attempts / 2) + " edges line up along the " +
                  "xyz"[axis] + " axis at " + point_text(geometry.position(part[0])) +
                  ": turn the mesh a little");
}

RayCastFrontWinding::Count RayCastFrontWinding::cast(const ExactPoint& origin, int axis,
                                                     int direction, Index component) const {
  const PlaneProjection projection{(axis + 1) % 3, (axis + 2) % 3};
  const ExactGeometry geometry(welded_.points, welded_.faces);
  const SideFilter filter(origin, projection);
  Vec3 low = origin.center - origin.radius;
  Vec3 high = origin.center + origin.radius;
  (direction > 0 ? high : low)[axis] = direction * std::numeric_limits<double>::max();

  Count count;
  const auto cross = [&](const Triangle& t) {
    bool left = false, right = false, on = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = t[k], &b = t[(k + 1) % 3];
      int side_of_edge = filter.side_of(a, b);
      if (side_of_edge == 0)
        side_of_edge =
            geometry.orient2d(ExactGeometry::free(a), ExactGeometry::free(b), origin, projection);
      left |= side_of_edge > 0;
      right |= side_of_edge < 0;
      on |= side_of_edge == 0;
    }
    if (left && right) return true;
    if (on) {
      count.grazes = true;
      return false;
    }
    const int up = left ? 1 : -1;  // the sign of the normal along the axis
    const int side = geometry.orient3d(t, origin);
    if (side * up * direction < 0) count.winding += up * direction;
    return true;
  };
  visit_overlaps(low, high, [&](Index i) {
    const bool counts = only_for_.empty() || only_for_[i] == no_index || only_for_[i] == component;
    return !counts || cross(triangle(i));
  });
  if (around_ && !count.grazes) around_->faces.visit_overlaps(low, high, axis, cross);
  return count;
}

}  // namespace transformesh
