#include "clean/exterior/ray_cast_front_winding.h"

#include <cmath>
#include <limits>
#include <string>

#include "mesh/location_text.h"
#include "support/numbered_selection.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

// Limit of points tried on a piece; its square fits into an int.
constexpr int most_points_on_piece = 20000;
constexpr std::size_t faces_per_task = 4096;  ///< affects time only
/// Up to this number of rays, no tree is built; affects time only.
constexpr std::size_t few_rays = 8;
/// Number of reference points (points with known winding number) from which segments to one point
/// of a piece are tried. Up to three of them may be in the plane of the piece. Segments from these
/// points are useless.
constexpr int references_per_origin = 4;

Bvh build_bvh(const WeldedMesh& welded) {
  std::vector<FloatBox> boxes(welded.faces.size());
  parallel_for(boxes.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) boxes[f] = welded.box(static_cast<Index>(f));
  });
  return Bvh(boxes);
}

/// Floating-point filter for the side of a projected edge on which a point is. The side is 0 if
/// rounding errors leave it undecided.
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
  /// Upper bound of the relative rounding error of the orientation.
  static constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  static constexpr double underflow_guard = 1e-280;

  PlaneProjection p_;
  double u_, v_, radius_u_, radius_v_;
};

// Returns barycentric weights of a point inside a triangle. The points of all attempts are on a
// conic; the first is the centroid.
std::array<int, 3> weights(int attempt) { return {1, attempt, attempt * attempt}; }

}  // namespace

RayCastFrontWinding::RayCastFrontWinding(const WeldedMesh& welded, std::size_t rays,
                                         const Surroundings* around)
    : welded_(welded) {
  if (rays > few_rays || around) bvh_ = build_bvh(welded_);
  if (!around) return;
  references_ = std::make_unique<LocalReferences>(
      *around, [this](const Vec3& low, const Vec3& high, const LocalReferences::Visit& visit) {
        visit_overlaps(low, high, [&](Index f) { return visit(welded_.triangle(f)); });
      });
}

void RayCastFrontWinding::visit_overlaps(const Vec3& low, const Vec3& high,
                                         const std::function<bool(Index)>& visit) const {
  if (!bvh_.empty()) return bvh_.visit_overlaps(welded_.frame.box(low, high), visit);
  const NumberedSelection overlapping(welded_.faces.size(), [&](std::size_t f) {
    const Triangle t = welded_.triangle(static_cast<Index>(f));
    return (t[0].cwiseMin(t[1]).cwiseMin(t[2]).array() <= high.array()).all() &&
           (t[0].cwiseMax(t[1]).cwiseMax(t[2]).array() >= low.array()).all();
  });
  for (const Index face : overlapping.list())
    if (!visit(face)) return;
}

int RayCastFrontWinding::in_front_of(const Arrangement& arrangement, const Piece& piece) const {
  const auto& [a, b, c] = piece.corners;
  return in_front_of({arrangement.point(a), arrangement.point(b), arrangement.point(c)},
                     arrangement.sources_of(piece).front());
}

std::vector<FaceCrossing> RayCastFrontWinding::crossings_in_front_of(const Arrangement& arrangement,
                                                                     const Piece& piece) const {
  const auto& [a, b, c] = piece.corners;
  std::vector<FaceCrossing> crossings;
  in_front_of({arrangement.point(a), arrangement.point(b), arrangement.point(c)},
              arrangement.sources_of(piece).front(), &crossings);
  return crossings;
}

std::vector<FaceCrossing> RayCastFrontWinding::crossings_in_front_of(Index face) const {
  const ExactGeometry geometry(welded_.points, welded_.faces);
  const auto& [a, b, c] = welded_.faces[face];
  std::vector<FaceCrossing> crossings;
  in_front_of({geometry.given(a), geometry.given(b), geometry.given(c)}, {face, false}, &crossings);
  return crossings;
}

int RayCastFrontWinding::in_front_of(const std::array<ExactPoint, 3>& part, Index face) const {
  return in_front_of(part, PieceSource{face, false});
}

std::optional<int> RayCastFrontWinding::in_front_of(const ExactPoint& point, Index face) const {
  const Count count = cast(point, {face, false});
  return count.grazes ? std::nullopt : std::optional(count.winding);
}

// Returns the axis that is nearest to the normal of the piece's face, and the sign of the direction
// along this axis in which the front of the piece is.
std::pair<int, int> RayCastFrontWinding::axis_and_direction(const PieceSource& source) const {
  const PlaneProjection projection = projection_of(welded_.triangle(source.face));
  const bool even = projection.v == (projection.u + 1) % 3;
  return {3 - projection.u - projection.v, even != source.reversed ? 1 : -1};
}

int RayCastFrontWinding::in_front_of(const std::array<ExactPoint, 3>& part,
                                     const PieceSource& source,
                                     std::vector<FaceCrossing>* crossings) const {
  const ExactGeometry geometry(welded_.points, welded_.faces);
  // The points that weights() gives are on a conic. A ray touches an edge if it starts on the
  // projection of this edge to the piece. The projection is a segment, which intersects the conic
  // at most twice. Hence each edge makes at most two attempts fail. The same holds for segments
  // from a reference point outside the plane of the piece.
  for (int attempt = 1; attempt <= most_points_on_piece; ++attempt) {
    const ExactPoint origin = geometry.mean(part[0], part[1], part[2], weights(attempt));
    if (crossings) crossings->clear();
    const Count count = cast(origin, source, crossings);
    if (!count.grazes) return count.winding;
  }
  const int axis = axis_and_direction(source).first;
  throw GoalError("more than " + std::to_string(most_points_on_piece / 2) +
                  " edges line up along the " + "xyz"[axis] + " axis at " +
                  point_text(geometry.position(part[0])) + ": rotate the mesh slightly");
}

RayCastFrontWinding::Count RayCastFrontWinding::cast(const ExactPoint& origin,
                                                     const PieceSource& source,
                                                     std::vector<FaceCrossing>* crossings) const {
  if (!references_) return cast_ray(origin, source, crossings);
  for (int attempt = 0; attempt < references_per_origin; ++attempt) {
    const std::optional<ReferencePoint> from = references_->near(origin.center, attempt);
    if (!from) continue;
    const Count count = cross_segment(*from, origin, source);
    if (!count.grazes) return count;
  }
  return {true, 0};
}

RayCastFrontWinding::Count RayCastFrontWinding::cast_ray(
    const ExactPoint& origin, const PieceSource& source,
    std::vector<FaceCrossing>* crossings) const {
  const auto [axis, direction] = axis_and_direction(source);
  const PlaneProjection projection{(axis + 1) % 3, (axis + 2) % 3};
  const ExactGeometry geometry(welded_.points, welded_.faces);
  const SideFilter filter(origin, projection);
  Vec3 low = origin.center - origin.radius;
  Vec3 high = origin.center + origin.radius;
  (direction > 0 ? high : low)[axis] = direction * std::numeric_limits<double>::max();

  Count count;
  const auto cross = [&, direction = direction](Index face) {
    const Triangle t = welded_.triangle(face);
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
    const int up = left ? 1 : -1;  // sign of the normal along the axis
    const int side = geometry.orient3d(t, origin);
    if (side * up * direction >= 0) return true;
    count.winding += up * direction;
    if (crossings) crossings->push_back({face, up * direction});
    return true;
  };
  visit_overlaps(low, high, [&](Index face) { return welded_.is_open(face) || cross(face); });
  return count;
}

// Counts the faces between the reference point `from` and a point just in front of the piece, near
// its point `origin`. If a face contains `origin`, the face is coplanar with the piece. The end of
// the segment is in front of such a face if face and piece have the same orientation, and behind it
// otherwise. If the reference point is in the plane of a face, the segment does not cross this
// face.
RayCastFrontWinding::Count RayCastFrontWinding::cross_segment(const ReferencePoint& from,
                                                              const ExactPoint& origin,
                                                              const PieceSource& source) const {
  const ExactGeometry geometry(welded_.points, welded_.faces);
  const Triangle piece = welded_.triangle(source.face);
  const Vec3& start = from.position;
  Count count{false, from.winding};
  const auto cross = [&](Index f) {
    const Triangle t = welded_.triangle(f);
    const int side_of_start = orient3d(t[0], t[1], t[2], start);
    if (side_of_start == 0) return true;
    int side_of_end = geometry.orient3d(t, origin);
    if (side_of_end == 0) side_of_end = normals_dot(t, piece) * (source.reversed ? -1 : 1);
    if (side_of_end == side_of_start) return true;
    bool left = false, right = false, on = side_of_end == 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int side = geometry.orient3d(Triangle{start, t[k], t[(k + 1) % 3]}, origin);
      left |= side > 0;
      right |= side < 0;
      on |= side == 0;
    }
    if (left && right) return true;
    count.grazes = on;
    if (!on) count.winding += side_of_start;
    return !on;
  };
  visit_overlaps(start.cwiseMin(origin.center - origin.radius),
                 start.cwiseMax(origin.center + origin.radius), cross);
  return count;
}

}  // namespace transformesh
