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

constexpr PlaneProjection ray_view{1, 2};  ///< along the rays, which have the direction (1, 0, 0)

/// True if the projection of the point is in the projected triangle or on its boundary. Also true
/// for some points that are collinear with a triangle whose projection has no area.
bool may_meet(const Triangle& t, const Vec3& point, PlaneProjection view) {
  return common_sign(orient2d(t[0], t[1], point, view), orient2d(t[1], t[2], point, view),
                     orient2d(t[2], t[0], point, view))
      .has_value();
}

/// True if a point in the plane of the triangle is in the triangle or on its boundary.
bool contains(const Triangle& t, const Vec3& point) {
  return has_two_sides(t) && may_meet(t, point, projection_of(t));
}

/// Returns the side of the projected edge from a to b on which the shifted point is. The shift is
/// infinitely small along -z, and infinitely smaller along -y. Returns 0 only if the projections of
/// both ends are equal. (Edelsbrunner & Muecke, "Simulation of simplicity", 1990.)
int shifted_side(const Vec3& a, const Vec3& b, const Vec3& point) {
  if (const int side = orient2d(a, b, point, ray_view); side != 0) return side;
  if (a.y() != b.y()) return a.y() > b.y() ? 1 : -1;
  return a.z() < b.z() ? 1 : a.z() > b.z() ? -1 : 0;
}

/// Orientation of the projected triangle if the line along x through the shifted point meets it: 1
/// if the line leaves the triangle at its front, -1 at its back. Otherwise 0.
int shifted_turn(const Triangle& t, const Vec3& point) {
  return common_sign(shifted_side(t[0], t[1], point), shifted_side(t[1], t[2], point),
                     shifted_side(t[2], t[0], point))
      .value_or(0);
}

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

std::optional<int> RayCastWinding::operator()(const Vec3& point) const {
  FloatBox ray = frame_.box(point, point);
  ray.max()[0] = infinity;
  bool is_on_surface = false;
  int winding = 0;
  bvh_.visit_overlaps(ray, [&](Index face) {
    const Triangle t = triangle_of(*mesh_, face);
    if (!may_meet(t, point, ray_view)) return true;
    const int side = orient3d(t[0], t[1], t[2], point);
    is_on_surface = side == 0 && contains(t, point);
    if (const int turn = shifted_turn(t, point); turn * side < 0) winding += turn;
    return !is_on_surface;
  });
  if (is_on_surface) return std::nullopt;
  return winding;
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
