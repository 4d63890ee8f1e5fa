#include "clean/flat/merge_flat.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "clean/flat/flat_outlines.h"
#include "clean/flat/short_edges.h"
#include "clean/intersect/welded_mesh.h"
#include "clean/rounding/broken_faces.h"
#include "io/polygons/planar_outline.h"
#include "mesh/adjacency.h"
#include "transformesh/components.h"

namespace transformesh {
namespace {

/// Projects vertices along the coordinate axis nearest to the normal, such that triangles keep
/// their orientation. The coordinates are not changed, so predicates stay exact.
std::vector<Eigen::Vector2d> projected(const Mesh& mesh, const std::vector<Index>& vertices,
                                       const Vec3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  Eigen::Index first = (axis + 1) % 3, second = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(first, second);
  std::vector<Eigen::Vector2d> points;
  points.reserve(vertices.size());
  for (const Index v : vertices)
    points.emplace_back(mesh.positions[v][first], mesh.positions[v][second]);
  return points;
}

/// True if the oriented boundary edges of the triangles are exactly the edges of the outlines. They
/// can differ if several vertices have the same projection.
bool have_boundary(const std::vector<CornerTriangle>& triangles,
                   const std::vector<std::vector<Index>>& outlines) {
  std::vector<std::array<Index, 2>> there, back;
  for (const auto& [a, b, c] : triangles) there.insert(there.end(), {{a, b}, {b, c}, {c, a}});
  for (const auto& [from, to] : there) back.push_back({to, from});
  for (const std::vector<Index>& outline : outlines)
    for (std::size_t i = 0; i < outline.size() && outline.size() > 1; ++i) {
      const Index from = outline[i], to = outline[(i + 1) % outline.size()];
      there.push_back({to, from});
      back.push_back({from, to});
    }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  return there == back;
}

/// Returns a triangulation of the region whose outlines are `left`. Returns no faces if a
/// triangulation is not possible.
std::vector<Face> triangulated(const Mesh& mesh, const FlatRegion& region, RegionOutlines left) {
  std::vector<Index> vertices;
  for (const std::vector<Index>& outline : left.outlines)
    vertices.insert(vertices.end(), outline.begin(), outline.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (std::vector<Index>& outline : left.outlines)
    for (Index& v : outline)
      v = static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                             vertices.begin());
  const PlanarTriangles found =
      triangulate_outlines(projected(mesh, vertices, region.normal), left.outlines);
  std::vector<Face> faces;
  if (!found.is_complete || found.folds > 0 || !found.flat.empty() ||
      found.triangles.size() != left.faces || !have_boundary(found.triangles, left.outlines))
    return faces;
  for (const auto& [a, b, c] : found.triangles)
    faces.push_back({vertices[a], vertices[b], vertices[c]});
  return faces;
}

/// Returns 1 for each vertex whose position is also the position of another vertex.
std::vector<char> find_copies(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  std::vector<char> has_copy(mesh.positions.size(), 0);
  for (Index v = 0; v < has_copy.size(); ++v) {
    const Index first = welded.vertex_of[welded.point_of[v]];
    if (first != v) has_copy[first] = has_copy[v] = 1;
  }
  return has_copy;
}

class FlatMerger {
 public:
  FlatMerger(Mesh& mesh, const std::vector<char>& wanted, const std::vector<char>& has_copy,
             double spacings, Scalar coordinate)
      : mesh_(mesh),
        opposites_(opposite_halfedges(mesh)),
        surface_{mesh, opposites_, has_copy, spacings, coordinate},
        flat_(find_flat_regions(mesh, opposites_, wanted, spacings, coordinate)) {}
  MergeFlatResult run(const Progress& progress);

 private:
  /// The new faces of all regions, and the region of each new face.
  struct Plan {
    std::vector<Face> faces;
    std::vector<Index> regions;
    double movement = 0;
  };

  Plan plan();
  Assembly applied(const Plan& plan) const;
  bool give_up_double_edges(const Plan& plan);
  bool give_up_broken(const Plan& plan, const Assembly& merged);
  void give_up(Index region);
  MergeFlatResult finish(const Plan& plan, Assembly merged);

  Mesh& mesh_;
  std::vector<Index> opposites_;
  FlatSurface surface_;
  FlatRegions flat_;
  std::vector<char> is_replaced_;  ///< 1 for each region whose faces are replaced
  MergeFlatResult result_;
};

void FlatMerger::give_up(Index region) {
  for (const Index face : flat_.regions[region].faces) flat_.of_face[face] = no_index;
  flat_.regions[region].faces.clear();
  ++result_.kept_regions;
}

/// Triangulates all regions with removed vertices. If this is not possible for a region, the region
/// keeps its faces, and the others are triangulated again.
FlatMerger::Plan FlatMerger::plan() {
  for (;;) {
    FlatOutlines outlines(surface_, flat_.of_face);
    Plan plan{{}, {}, outlines.movement()};
    bool is_whole = true;
    is_replaced_.assign(flat_.regions.size(), 0);
    for (Index r = 0; r < flat_.regions.size(); ++r) {
      const FlatRegion& region = flat_.regions[r];
      if (region.faces.empty() || !outlines.changes(region)) continue;
      const std::vector<Face> faces = triangulated(mesh_, region, outlines.of(region));
      if (faces.empty()) {
        give_up(r);
        is_whole = false;
      }
      is_replaced_[r] = 1;
      plan.faces.insert(plan.faces.end(), faces.begin(), faces.end());
      plan.regions.insert(plan.regions.end(), faces.size(), r);
    }
    if (is_whole) return plan;
  }
}

/// If a new edge of a region already exists elsewhere in the mesh, the region keeps its old faces.
/// Returns true if there are regions of this kind.
bool FlatMerger::give_up_double_edges(const Plan& plan) {
  struct Edge {
    std::array<Index, 2> ends;
    Index region;
    auto operator<=>(const Edge&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm
  };
  std::vector<char> is_at_region(mesh_.positions.size(), 0);
  for (const Face& face : plan.faces)
    for (const Index v : face) is_at_region[v] = 1;
  std::vector<Edge> edges;
  const auto add = [&](const Face& face, Index region) {
    for (std::size_t i = 0; i < 3; ++i)
      if (is_at_region[face[i]] && is_at_region[face[(i + 1) % 3]])
        edges.push_back({{face[i], face[(i + 1) % 3]}, region});
  };
  for (std::size_t i = 0; i < plan.faces.size(); ++i) add(plan.faces[i], plan.regions[i]);
  for (Index f = 0; f < mesh_.faces.size(); ++f) {
    const Index region = flat_.of_face[f];
    if (region == no_index || !is_replaced_[region]) add(mesh_.faces[f], no_index);
  }
  std::sort(edges.begin(), edges.end());
  std::vector<char> is_double(flat_.regions.size(), 0);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    if (edges[i].ends == edges[i + 1].ends)
      for (const Edge& edge : {edges[i], edges[i + 1]})
        if (edge.region != no_index) is_double[edge.region] = 1;
  bool is_any = false;
  for (Index r = 0; r < is_double.size(); ++r) {
    if (!is_double[r]) continue;
    give_up(r);
    is_any = true;
  }
  return is_any;
}

/// Returns the mesh without the replaced faces, followed by the new faces.
Assembly FlatMerger::applied(const Plan& plan) const {
  Assembly merged;
  std::vector<Index> rows;
  for (Index f = 0; f < mesh_.faces.size(); ++f) {
    const Index region = flat_.of_face[f];
    if (region == no_index || !is_replaced_[region]) rows.push_back(f);
  }
  merged.mesh.positions = mesh_.positions;
  for (const Index row : rows) merged.mesh.faces.push_back(mesh_.faces[row]);
  merged.face_is_new.assign(rows.size(), 0);
  merged.mesh.faces.insert(merged.mesh.faces.end(), plan.faces.begin(), plan.faces.end());
  merged.face_is_new.resize(merged.mesh.faces.size(), 1);
  for (const Index region : plan.regions) rows.push_back(flat_.regions[region].faces.front());
  merged.source_face = std::move(rows);
  return merged;
}

/// If a new face of a region intersects another face or has no area, the region keeps its old
/// faces. Returns true if there are regions of this kind.
bool FlatMerger::give_up_broken(const Plan& plan, const Assembly& merged) {
  const std::size_t first_new = merged.mesh.faces.size() - plan.faces.size();
  bool is_any = false;
  for (const Index face : find_broken_faces(merged).faces) {
    if (face < first_new) continue;
    const Index region = plan.regions[face - first_new];
    if (flat_.regions[region].faces.empty()) continue;
    give_up(region);
    is_any = true;
  }
  return is_any;
}

MergeFlatResult FlatMerger::finish(const Plan& plan, Assembly merged) {
  double heights = 0;
  for (Index r = 0; r < flat_.regions.size(); ++r) {
    if (!is_replaced_[r]) continue;
    ++result_.regions;
    heights = std::max(heights, flat_.regions[r].high - flat_.regions[r].low);
  }
  result_.removed_faces = mesh_.faces.size() - merged.mesh.faces.size();
  result_.displacement = heights + plan.movement;
  merged.mesh.vertex_columns = std::move(mesh_.vertex_columns);
  merged.mesh.face_columns = mesh_.face_columns.select(merged.source_face);
  mesh_ = select_faces(merged.mesh, std::vector<bool>(merged.mesh.faces.size(), true));
  return result_;
}

MergeFlatResult FlatMerger::run(const Progress& progress) {
  for (;;) {
    progress("merge");
    const Plan next = plan();
    if (give_up_double_edges(next)) continue;
    Assembly merged = applied(next);
    if (!give_up_broken(next, merged)) return finish(next, std::move(merged));
  }
}

}  // namespace

MergeFlatResult merge_flat(Mesh& mesh, std::vector<char> wanted, double spacings, Scalar coordinate,
                           const Progress& progress, const std::vector<char>& fixed) {
  const std::size_t before = mesh.faces.size();
  std::vector<char> has_copy = find_copies(mesh);
  for (std::size_t v = 0; v < fixed.size(); ++v) has_copy[v] = has_copy[v] | fixed[v];
  const Displacement moved = collapse_short_edges(mesh, wanted, has_copy, spacings, coordinate);
  const std::size_t collapsed = before - mesh.faces.size();
  MergeFlatResult result = FlatMerger(mesh, wanted, has_copy, spacings, coordinate).run(progress);
  result.removed_faces += collapsed;
  result.displacement += moved.length;
  return result;
}

}  // namespace transformesh
