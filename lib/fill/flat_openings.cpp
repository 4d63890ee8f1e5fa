#include "fill/flat_openings.h"

#include <Eigen/Geometry>

#include "geometry/numbers/predicates.h"
#include "geometry/search/bvh.h"
#include "io/polygons/planar_outline.h"
#include "mesh/triangle.h"

namespace transformesh {
namespace {

/// Largest distance of an opening from the plane of its outer loop, as fraction of the diagonal of
/// the loop's bounding box. Floats at 100,000 times the size of a part have distances of 0.5 %.
/// If the value were much larger, curved openings would get patches in a plane.
constexpr double flatness = 1e-2;

/// The plane of a loop.
struct FlatLoop {
  Eigen::AlignedBox3d box;
  Vec3 normal = Vec3::Zero();  ///< unit normal of a patch for this loop alone
  double area = 0;             ///< twice the area in the plane
  bool is_flat = false;        ///< true if the loop lies nearly in its plane
};

/// Returns a projection in which loops that are counter-clockwise around the normal stay so.
PlaneProjection projection_along(const Vec3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const int u = static_cast<int>((axis + 1) % 3), v = static_cast<int>((axis + 2) % 3);
  return normal[axis] < 0 ? PlaneProjection{v, u} : PlaneProjection{u, v};
}

Eigen::Vector2d projected(const Vec3& point, PlaneProjection p) { return {point[p.u], point[p.v]}; }

FlatLoop describe(const Mesh& mesh, const HoleLoop& loop) {
  FlatLoop flat;
  const Vec3& first = mesh.positions[halfedge_source(mesh, loop.front())];
  Vec3 sum = Vec3::Zero();
  for (const Index h : loop) {
    flat.box.extend(mesh.positions[halfedge_source(mesh, h)]);
    sum -= normal_of(first, mesh.positions[halfedge_source(mesh, h)],
                     mesh.positions[halfedge_target(mesh, h)]);
  }
  flat.area = sum.stableNorm();
  flat.normal = sum.stableNormalized();
  const double limit = flatness * flat.box.diagonal().stableNorm();
  flat.is_flat = flat.area > 0;
  for (const Index h : loop) {
    const Vec3& p = mesh.positions[halfedge_source(mesh, h)];
    if (std::abs(flat.normal.dot(p - first)) > limit) flat.is_flat = false;
  }
  return flat;
}

/// True if a point is a vertex of a loop, or inside of it in the projection: a ray crosses the loop
/// an odd number of times.
bool surrounds(const Mesh& mesh, const HoleLoop& loop, PlaneProjection projection,
               const Vec3& point) {
  const Eigen::Vector2d p = projected(point, projection);
  bool is_inside = false;
  for (const Index h : loop) {
    if (mesh.positions[halfedge_source(mesh, h)] == point) return true;
    const Eigen::Vector2d a = projected(mesh.positions[halfedge_source(mesh, h)], projection);
    const Eigen::Vector2d b = projected(mesh.positions[halfedge_target(mesh, h)], projection);
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    is_inside ^= x > p.x();
  }
  return is_inside;
}

/// True if the inner loop has the opposite direction, and lies in the plane of the outer loop and
/// inside of it.
bool is_within(const Mesh& mesh, const FlatLoop& inner, const HoleLoop& inner_loop,
               const FlatLoop& outer, const HoleLoop& outer_loop) {
  if (!(inner.normal.dot(outer.normal) < -0.9) || !(inner.area < outer.area)) return false;
  const Vec3& center = mesh.positions[halfedge_source(mesh, outer_loop.front())];
  const double limit = flatness * outer.box.diagonal().stableNorm();
  const PlaneProjection projection = projection_along(outer.normal);
  for (const Index h : inner_loop) {
    const Vec3& p = mesh.positions[halfedge_source(mesh, h)];
    if (std::abs(outer.normal.dot(p - center)) > limit) return false;
    if (!surrounds(mesh, outer_loop, projection, p)) return false;
  }
  return true;
}

/// Returns for each loop the smallest loop around it, or no_index.
std::vector<Index> outer_loops(const Mesh& mesh, const std::vector<HoleLoop>& loops) {
  std::vector<Index> outer(loops.size(), no_index);
  std::vector<FlatLoop> flat;
  const BoxFrame frame(mesh.positions);
  std::vector<FloatBox> boxes;
  for (const HoleLoop& loop : loops) {
    flat.push_back(describe(mesh, loop));
    boxes.push_back(frame.box(flat.back().box.min(), flat.back().box.max()));
  }
  const Bvh tree(boxes);
  for (Index i = 0; i < loops.size(); ++i) {
    tree.visit_overlaps(boxes[i], [&](Index o) {
      const bool is_smaller = outer[i] == no_index || flat[o].area < flat[outer[i]].area ||
                              (flat[o].area == flat[outer[i]].area && o < outer[i]);
      if (o != i && flat[o].is_flat && is_smaller &&
          is_within(mesh, flat[i], loops[i], flat[o], loops[o]))
        outer[i] = o;
      return true;
    });
  }
  return outer;
}

}  // namespace

std::vector<std::vector<HoleLoop>> group_flat_openings(const Mesh& mesh,
                                                       std::vector<HoleLoop> loops) {
  const std::vector<Index> outer = outer_loops(mesh, loops);
  std::vector<std::vector<HoleLoop>> groups(loops.size());
  // A loop that is within another one is no outer loop.
  const auto root = [&](Index i) {
    return outer[i] != no_index && outer[outer[i]] == no_index ? outer[i] : i;
  };
  for (Index i = 0; i < loops.size(); ++i)
    if (root(i) == i) groups[i].push_back(loops[i]);
  for (Index i = 0; i < loops.size(); ++i)
    if (root(i) != i) groups[root(i)].push_back(std::move(loops[i]));
  std::erase_if(groups, [](const std::vector<HoleLoop>& group) { return group.empty(); });
  return groups;
}

std::vector<Face> triangulate_opening(const Mesh& mesh, const std::vector<HoleLoop>& loops) {
  const PlaneProjection projection = projection_along(describe(mesh, loops.front()).normal);
  std::vector<Eigen::Vector2d> points;
  points.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) points.push_back(projected(p, projection));
  std::vector<std::vector<Index>> outlines;
  for (const HoleLoop& loop : loops) {
    std::vector<Index>& outline = outlines.emplace_back();
    for (const Index h : loop) outline.insert(outline.begin(), halfedge_source(mesh, h));
  }
  const PlanarTriangles found = triangulate_outlines(points, outlines);
  if (!found.is_complete || found.folds > 0 || !found.flat.empty()) return {};
  return {found.triangles.begin(), found.triangles.end()};
}

}  // namespace transformesh
