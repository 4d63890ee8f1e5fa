#include "fill/slit_clearance.h"

#include <algorithm>

#include "geometry/solid_angle_winding.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

Box box_of(const std::vector<Triangle>& triangles) {
  Box box;
  for (const Triangle& triangle : triangles)
    for (const Vec3& corner : triangle) box.extend(corner);
  return box;
}

void append(Mesh& mesh, const std::vector<Triangle>& triangles) {
  for (const Triangle& triangle : triangles) {
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), triangle.begin(), triangle.end());
    mesh.faces.push_back({first, first + 1, first + 2});
  }
}

bool intersect(const std::vector<Triangle>& first, const std::vector<Triangle>& second) {
  Mesh both;
  append(both, first);
  append(both, second);
  const std::vector<FacePair> pairs = find_intersections(both);
  return std::ranges::any_of(pairs, [&](const FacePair& pair) {
    return pair.first < first.size() && pair.second >= first.size();
  });
}

/// Returns the boundary of the slab, the space between the two patches of a slit, as a closed mesh.
Mesh slab_of(const ClosedSlit& slit) {
  Mesh slab;
  append(slab, slit.left_patch());
  append(slab, slit.right_patch());
  const std::vector<Vec3>&left = slit.left.loop, &right = slit.right.loop;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const std::size_t next = (i + 1) % left.size();
    append(slab, {{left[i], left[next], right[next]}, {left[i], right[next], right[i]}});
  }
  return slab;
}

}  // namespace

// Returns the vertices of the loop and their neighbors, in ascending order. Loop vertices may occur
// several times.
std::vector<Index> SlitClearance::near_vertices(const std::vector<Index>& loop) const {
  std::vector<Index> near = loop;
  for (const Index v : loop)
    stars_.visit(v, [&](Index h) { near.push_back(halfedge_target(mesh_, h)); });
  std::ranges::sort(near);
  return near;
}

// Returns the triangles of both patches, and the faces at the loop with the new positions of loop
// vertices.
std::vector<Triangle> SlitClearance::surface_of(const std::vector<Index>& loop,
                                                const SlitSides& sides,
                                                const ClosedSlit& slit) const {
  std::vector<Triangle> surface = slit.left_patch();
  const std::vector<Triangle> right = slit.right_patch();
  surface.insert(surface.end(), right.begin(), right.end());
  const auto add_drawn = [&](const SlitSide& side, const DrawnSide& drawn) {
    for (const std::vector<Index>& corners : side.corners)
      for (const Index corner : corners) {
        Triangle& triangle = surface.emplace_back(triangle_of(mesh_, corner / 3));
        for (std::size_t i = 0; i < 3; ++i) {
          const auto at = std::ranges::find(loop, mesh_.faces[corner / 3][i]);
          if (at != loop.end()) triangle[i] = drawn.loop[at - loop.begin()];
        }
      }
  };
  add_drawn(sides.left, slit.left);
  add_drawn(sides.right, slit.right);
  return surface;
}

std::vector<Triangle> SlitClearance::others_near(const std::vector<Index>& loop, const Box& box) {
  if (faces_.empty()) faces_ = Bvh(mesh_);
  const std::vector<Index> near = near_vertices(loop);
  std::vector<Index> found;
  faces_.visit_overlaps(float_box(box.min(), box.max()), [&](Index f) {
    const bool counts = std::ranges::none_of(
        mesh_.faces[f], [&](Index v) { return std::ranges::binary_search(near, v); });
    if (counts) found.push_back(f);
    return true;
  });
  std::vector<Triangle> others;
  for (const Index f : found) others.push_back(triangle_of(mesh_, f));
  for (const std::vector<Triangle>& triangles : taken_)
    if (box_of(triangles).intersects(box))
      others.insert(others.end(), triangles.begin(), triangles.end());
  return others;
}

bool SlitClearance::is_free(const std::vector<Index>& loop, const SlitSides& sides,
                            const ClosedSlit& slit) {
  const std::vector<Triangle> surface = surface_of(loop, sides, slit);
  const std::vector<Triangle> others = others_near(loop, box_of(surface));
  if (others.empty()) return true;
  if (intersect(others, surface)) return false;
  const Mesh slab = slab_of(slit);
  const SolidAngleWinding winding(slab);
  return std::ranges::none_of(others, [&](const Triangle& triangle) {
    return std::abs(winding(triangle[0]).number) > 0.5;
  });
}

void SlitClearance::take(const std::vector<Index>& loop, const SlitSides& sides,
                         const ClosedSlit& slit) {
  taken_.push_back(surface_of(loop, sides, slit));
}

}  // namespace transformesh
