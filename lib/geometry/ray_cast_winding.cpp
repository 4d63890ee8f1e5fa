#include "geometry/ray_cast_winding.h"

#include <limits>

namespace transformesh {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Returns the common sign of three numbers, or nothing if two have opposite signs. Returns 0 if
/// some are 0 and the others do not have opposite signs.
std::optional<int> common_sign(int a, int b, int c) {
  const int lowest = std::min({a, b, c});
  const int highest = std::max({a, b, c});
  if (lowest < 0 && highest > 0) return std::nullopt;
  return a == b && b == c ? a : 0;
}

bool has_two_sides(const Triangle& t) { return !collinear(t[0], t[1], t[2]); }

}  // namespace

RayCastWinding::RayCastWinding(const Mesh& mesh) : mesh_(&mesh), frame_(mesh.positions) {
  std::vector<FloatBox> boxes;
  boxes.reserve(mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    boxes.push_back(frame_.box(p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)));
  }
  bvh_ = Bvh(boxes);
}

std::optional<int> RayCastWinding::cast(const Vec3& point, int axis, bool towards_infinity) const {
  FloatBox ray = frame_.box(point, point);
  const auto along = static_cast<std::size_t>(axis);
  (towards_infinity ? ray.max()[along] : ray.min()[along]) =
      towards_infinity ? infinity : -infinity;

  const PlaneProjection view{(axis + 1) % 3, (axis + 2) % 3};
  const int forward = towards_infinity ? 1 : -1;
  bool is_certain = true;
  int winding = 0;
  bvh_.visit_overlaps(ray, [&](Index face) {
    const Triangle t = triangle_of(*mesh_, face);
    // Orientation of the projected face around the line through the point in axis direction. It is
    // +1 if the line leaves the face at its front, -1 at its back, and 0 if the line meets the
    // boundary of the face. Nothing if the line misses the face.
    const std::optional<int> turn =
        common_sign(orient2d(t[0], t[1], point, view), orient2d(t[1], t[2], point, view),
                    orient2d(t[2], t[0], point, view));
    if (!turn) return true;
    const int side = orient3d(t[0], t[1], t[2], point);
    if (*turn == 0 ? has_two_sides(t) : side == 0) {
      is_certain = false;
    } else if (*turn * side * forward < 0) {
      winding += *turn * forward;
    }
    return is_certain;
  });
  if (!is_certain) return std::nullopt;
  return winding;
}

std::optional<int> RayCastWinding::operator()(const Vec3& point) const {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool towards_infinity : {true, false})
      if (const std::optional<int> winding = cast(point, axis, towards_infinity)) return winding;
  return std::nullopt;
}

bool RayCastWinding::blocks(const Vec3& from, const Vec3& to) const {
  bool is_blocked = false;
  bvh_.visit_overlaps(frame_.box(from.cwiseMin(to), from.cwiseMax(to)), [&](Index face) {
    const Triangle t = triangle_of(*mesh_, face);
    const int start = orient3d(t[0], t[1], t[2], from);
    const int end = orient3d(t[0], t[1], t[2], to);
    if (start == end && start != 0) return true;
    is_blocked = has_two_sides(t) &&
                 common_sign(orient3d(from, to, t[0], t[1]), orient3d(from, to, t[1], t[2]),
                             orient3d(from, to, t[2], t[0]))
                     .has_value();
    return !is_blocked;
  });
  return is_blocked;
}

}  // namespace transformesh
