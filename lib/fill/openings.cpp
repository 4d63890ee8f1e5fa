#include "fill/openings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "geometry/search/bvh.h"
#include "io/polygons/planar_outline.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"
#include "mesh/triangle.h"

namespace transformesh {
namespace {

/// Largest distance of an opening from the plane of its outer loop, as fraction of the diagonal of
/// the loop's bounding box. Floats at 100,000 times the size of a part have distances of 0.5 %.
/// If the value were much larger, curved openings would get patches in a plane.
constexpr double flatness = 1e-2;

/// The same fraction for openings around islands. A spherical cap of 53 degrees around its center
/// has a height of a quarter of its diameter. If the value were much larger, the rims of bodies
/// that only face each other would be joined.
constexpr double island_flatness = 0.25;

/// Least mean cosine of the angles between the normals of the faces at an island's rim and that of
/// the opening. It is 0.6 at the rim of that cap and 0 at walls.
constexpr double least_island_facing = 0.5;

/// The plane of a loop.
struct LoopPlane {
  Eigen::AlignedBox3d box;
  double diagonal = 0;         ///< length of the diagonal of the box
  Vec3 normal = Vec3::Zero();  ///< unit normal of a patch for this loop alone
  Vec3 center = Vec3::Zero();  ///< mean of the vertices
  double area = 0;             ///< twice the area in the plane
  double height = 0;           ///< largest distance from the plane
};

/// Two axes of a plane.
struct Projection {
  Vec3 u, v;
  Eigen::Vector2d operator()(const Vec3& point) const { return {point.dot(u), point.dot(v)}; }
};

/// Returns a projection in which loops that are counter-clockwise around the normal stay so. In
/// flat openings it drops a coordinate, so that nothing is rounded.
Projection projection_along(const Vec3& normal, bool is_flat) {
  if (!is_flat) {
    const Vec3 u = normal.unitOrthogonal();
    return {u, normal.cross(u)};
  }
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const Vec3 u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3);
  return normal[axis] < 0 ? Projection{v, u} : Projection{u, v};
}

/// Returns the largest distance of a loop from a plane.
double height_above(const Mesh& mesh, const HoleLoop& loop, const LoopPlane& plane) {
  double height = 0;
  for (const Index h : loop) {
    const Vec3& p = mesh.positions[halfedge_source(mesh, h)];
    height = std::max(height, std::abs(plane.normal.dot(p - plane.center)));
  }
  return height;
}

LoopPlane describe(const Mesh& mesh, const HoleLoop& loop) {
  LoopPlane plane;
  const Vec3& first = mesh.positions[halfedge_source(mesh, loop.front())];
  Vec3 sum = Vec3::Zero();
  for (const Index h : loop) {
    plane.box.extend(mesh.positions[halfedge_source(mesh, h)]);
    plane.center +=
        (mesh.positions[halfedge_source(mesh, h)] - first) / static_cast<double>(loop.size());
    sum -= normal_of(first, mesh.positions[halfedge_source(mesh, h)],
                     mesh.positions[halfedge_target(mesh, h)]);
  }
  plane.center += first;
  plane.diagonal = plane.box.diagonal().stableNorm();
  plane.area = sum.stableNorm();
  plane.normal = sum.stableNormalized();
  plane.height = height_above(mesh, loop, plane);
  return plane;
}

/// True if a point is a vertex of a loop, or inside of it in the projection: a ray crosses the loop
/// an odd number of times.
bool surrounds(const Mesh& mesh, const HoleLoop& loop, const Projection& projected,
               const Vec3& point) {
  const Eigen::Vector2d p = projected(point);
  bool is_inside = false;
  for (const Index h : loop) {
    if (mesh.positions[halfedge_source(mesh, h)] == point) return true;
    const Eigen::Vector2d a = projected(mesh.positions[halfedge_source(mesh, h)]);
    const Eigen::Vector2d b = projected(mesh.positions[halfedge_target(mesh, h)]);
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    is_inside ^= x > p.x();
  }
  return is_inside;
}

/// Returns sets of faces that are connected across edges.
DisjointSets edge_connected_parts(const Mesh& mesh) {
  DisjointSets parts(mesh.faces.size());
  const Edges edges(mesh);
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const Index h : edges.halfedges(e)) parts.join(edges.halfedges(e)[0] / 3, h / 3);
  return parts;
}

/// Finds the loops that are within others.
class Nesting {
 public:
  Nesting(const Mesh& mesh, const std::vector<HoleLoop>& loops)
      : mesh_(mesh), loops_(loops), parts_(edge_connected_parts(mesh)) {
    for (const HoleLoop& loop : loops) planes_.push_back(describe(mesh, loop));
  }

  /// Returns for each loop the smallest loop around it, or no_index.
  std::vector<Index> outer_loops();

 private:
  bool is_island(Index inner, Index outer);
  bool is_within(Index inner, Index outer);

  const Mesh& mesh_;
  const std::vector<HoleLoop>& loops_;
  std::vector<LoopPlane> planes_;
  DisjointSets parts_;
};

/// True if the faces at the inner loop face in the direction of the opening on average, unlike the
/// walls of a cavity. No edges may connect the first of them with a face at the outer loop. Islands
/// may touch the outer loop at vertices.
bool Nesting::is_island(Index inner, Index outer) {
  double facing = 0;
  for (const Index h : loops_[inner]) {
    const auto& [a, b, c] = triangle_of(mesh_, h / 3);
    facing += normal_of(a, b, c).stableNormalized().dot(planes_[outer].normal);
  }
  if (!(facing > least_island_facing * static_cast<double>(loops_[inner].size()))) return false;
  const Index part = parts_.find(loops_[inner].front() / 3);
  return std::ranges::none_of(loops_[outer], [&](Index h) { return parts_.find(h / 3) == part; });
}

/// True if the inner loop has the opposite direction, and lies inside of the outer loop in its
/// plane. Islands may be off the plane, as on a curved surface.
bool Nesting::is_within(Index inner, Index outer) {
  const LoopPlane &in = planes_[inner], &out = planes_[outer];
  if (!(in.normal.dot(out.normal) < -0.9) || !(in.area < out.area)) return false;
  const double height = std::max(out.height, height_above(mesh_, loops_[inner], out));
  const bool is_flat = height <= flatness * out.diagonal;
  if (!is_flat && (height > island_flatness * out.diagonal || !is_island(inner, outer)))
    return false;
  const Projection projection = projection_along(out.normal, is_flat);
  return std::ranges::all_of(loops_[inner], [&](Index h) {
    return surrounds(mesh_, loops_[outer], projection, mesh_.positions[halfedge_source(mesh_, h)]);
  });
}

std::vector<Index> Nesting::outer_loops() {
  std::vector<Index> outer(loops_.size(), no_index);
  const BoxFrame frame(mesh_.positions);
  std::vector<FloatBox> boxes, around;
  for (const LoopPlane& plane : planes_) {
    const Vec3 margin = Vec3::Constant(island_flatness * plane.diagonal);
    boxes.push_back(frame.box(plane.box.min(), plane.box.max()));
    around.push_back(frame.box(plane.box.min() - margin, plane.box.max() + margin));
  }
  const Bvh tree(around);
  for (Index i = 0; i < loops_.size(); ++i) {
    tree.visit_overlaps(boxes[i], [&](Index o) {
      const bool is_smaller = outer[i] == no_index || planes_[o].area < planes_[outer[i]].area ||
                              (planes_[o].area == planes_[outer[i]].area && o < outer[i]);
      if (o != i && is_smaller && is_within(i, o)) outer[i] = o;
      return true;
    });
  }
  return outer;
}

}  // namespace

std::vector<std::vector<HoleLoop>> group_openings(const Mesh& mesh, std::vector<HoleLoop> loops) {
  const std::vector<Index> outer = Nesting(mesh, loops).outer_loops();
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
  const LoopPlane outer = describe(mesh, loops.front());
  const bool is_flat = std::ranges::all_of(loops, [&](const HoleLoop& loop) {
    return height_above(mesh, loop, outer) <= flatness * outer.diagonal;
  });
  const Projection projected = projection_along(outer.normal, is_flat);
  std::vector<Eigen::Vector2d> points;
  points.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) points.push_back(projected(p));
  std::vector<std::vector<Index>> outlines;
  std::vector<std::pair<std::array<double, 2>, Index>> places;
  for (const HoleLoop& loop : loops) {
    std::vector<Index>& outline = outlines.emplace_back();
    for (const Index h : loop) {
      const Index v = halfedge_source(mesh, h);
      outline.insert(outline.begin(), v);
      places.push_back({{points[v].x(), points[v].y()}, v});
    }
  }
  std::ranges::sort(places);
  const auto coincide = [](const auto& a, const auto& b) {
    return a.first == b.first && a.second != b.second;
  };
  if (std::ranges::adjacent_find(places, coincide) != places.end()) return {};
  const PlanarTriangles found = triangulate_outlines(points, outlines);
  if (!found.is_complete || found.folds > 0 || !found.flat.empty()) return {};
  return {found.triangles.begin(), found.triangles.end()};
}

}  // namespace transformesh
