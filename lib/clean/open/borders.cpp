#include "clean/open/borders.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "clean/stitch/orient.h"
#include "clean/stitch/orientation_check.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"
#include "mesh/local_measures.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/stitch.h"

namespace transformesh {
namespace {

/// Two faces at an edge overlap if their angle is below 5e-5, of which this is the cosine. Values
/// from 1 - 1e-12 to 0 give the same results for 280 sets of cut boxes, in doubles and floats. With
/// 1 - 1e-15, one set in floats is refused. Flat parts that are reversed must not count as
/// overlapping, so the angle is small.
constexpr double cosine_of_overlap = 1 - 1e-9;

// Maps the start point of each border edge to its end point, in the direction of the face.
using BorderEdges = std::multimap<Index, Index>;

// Splits the border edges into boundary loops. Each point is the start of as many border edges as
// it is the end of, so each path along border edges closes.
std::vector<std::vector<Index>> walk(BorderEdges border) {
  std::vector<std::vector<Index>> loops;
  while (!border.empty()) {
    std::vector<Index>& loop = loops.emplace_back();
    Index at = border.begin()->first;
    for (auto step = border.find(at); step != border.end(); step = border.find(at)) {
      loop.push_back(at);
      at = step->second;
      border.erase(step);
    }
  }
  return loops;
}

// Returns the mesh with equal positions merged to one vertex.
Mesh with_joined_vertices(const WeldedMesh& welded, const Mesh& mesh) {
  Mesh result{mesh.positions, mesh.faces, {}, {}};
  for (Face& face : result.faces) {
    for (Index& v : face) v = welded.vertex_of[welded.point_of[v]];
  }
  return result;
}

// True if two faces at coinciding border edges do not overlap, so that they may be neighbors in one
// surface.
bool may_be_neighbors(const Mesh& mesh, const std::vector<Index>& halfedges) {
  for (const Index h : halfedges)
    for (const Index other : halfedges)
      if (h < other && !overlap(mesh, h, other)) return true;
  return false;
}

// The border halfedges of a mesh at each edge, which is named by its two points in ascending order.
// Edges without length are left out.
using BorderHalfedges = std::map<std::pair<Index, Index>, std::vector<Index>>;

BorderHalfedges border_halfedges(const WeldedMesh& welded, const Mesh& mesh,
                                 const ManifoldReport& report) {
  BorderHalfedges result;
  for (const Index h : report.border_halfedges) {
    const auto ends = std::minmax(
        {welded.point_of[halfedge_source(mesh, h)], welded.point_of[halfedge_target(mesh, h)]});
    if (ends.first != ends.second) result[ends].push_back(h);
  }
  return result;
}

// True if there is a connected set of border edges in which every edge coincides with another
// border edge, and some faces at them do not overlap. Then the surface inside this border has the
// wrong orientation. If all of them overlap, they belong to bodies that end at the same border, for
// instance to boxes with a common corner that was cut off.
bool has_reversed_patch(const BorderHalfedges& borders, const WeldedMesh& welded,
                        const Mesh& mesh) {
  DisjointSets rims(welded.points.size());
  for (const auto& [ends, halfedges] : borders) rims.join(ends.first, ends.second);
  std::set<Index> free_somewhere, apart_somewhere;
  for (const auto& [ends, halfedges] : borders) {
    if (halfedges.size() == 1) free_somewhere.insert(rims.find(ends.first));
    if (may_be_neighbors(mesh, halfedges)) apart_somewhere.insert(rims.find(ends.first));
  }
  return std::ranges::any_of(apart_somewhere,
                             [&](Index rim) { return !free_somewhere.contains(rim); });
}

// True if borders coincide in opposite directions, and their faces do not overlap. Then the surface
// continues there, although its faces have separate vertices.
bool has_gap(const BorderHalfedges& borders, const WeldedMesh& welded, const Mesh& mesh) {
  const auto start = [&](Index h) { return welded.point_of[halfedge_source(mesh, h)]; };
  return std::ranges::any_of(borders, [&](const auto& edge) {
    return std::ranges::any_of(edge.second, [&](Index h) {
      return std::ranges::any_of(edge.second, [&](Index other) {
        return start(h) < start(other) && !overlap(mesh, h, other);
      });
    });
  });
}

// True if find_oriented_borders() accepts the mesh after stitch(), which gives sheets (sets of
// connected faces) that end at another sheet their own vertices.
bool can_be_stitched(const Mesh& mesh) {
  Mesh stitched{mesh.positions, mesh.faces, {}, {}};
  stitch(stitched);
  const WeldedMesh welded = weld(stitched);
  const Borders borders = find_borders(welded, stitched);
  return borders.is_oriented || is_oriented_by_indices(welded, stitched);
}

// Throws the InputError for a mesh that is not oriented. The kind of the error tells whether
// reversing faces helps, or stitching, or neither; both are tried to find out.
[[noreturn]] void refuse_orientation(const WeldedMesh& welded, const Mesh& mesh) {
  Mesh oriented = with_joined_vertices(welded, mesh);
  const Problem problem = find_misorientation(oriented);
  orient_faces(oriented);
  const Problem rest = find_misorientation(oriented);
  if (rest.sentence.empty())
    throw InputError(problem.kind, problem.sentence + ": the mesh is not oriented", problem.data);
  const bool are_sheets = can_be_stitched(mesh);
  throw InputError(are_sheets ? ErrorKind::overlapping_sheets : ErrorKind::not_orientable,
                   rest.sentence + ", and reversing connected parts cannot change that", rest.data);
}

}  // namespace

bool is_oriented_by_indices(const WeldedMesh& welded, const Mesh& mesh) {
  const ManifoldReport report = check_manifold(mesh);
  if (!report.is_manifold() || !report.is_oriented()) return false;
  const BorderHalfedges borders = border_halfedges(welded, mesh, report);
  return !has_gap(borders, welded, mesh) && !(has_reversed_patch(borders, welded, mesh) &&
                                              can_be_oriented(with_joined_vertices(welded, mesh)));
}

bool overlap(const Mesh& mesh, Index halfedge, Index other) {
  return direction_into_face(mesh, halfedge).dot(direction_into_face(mesh, other)) >=
         cosine_of_overlap;
}

std::vector<Face> faces_by_points(const WeldedMesh& welded, const Mesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces)
    faces.push_back({welded.point_of[a], welded.point_of[b], welded.point_of[c]});
  return faces;
}

Borders find_borders(const WeldedMesh& welded, const Mesh& mesh) {
  // If no face was left out of the welded mesh, its faces and edges can be used.
  const bool are_same = welded.faces.size() == mesh.faces.size();
  const auto others = are_same ? std::vector<Face>() : faces_by_points(welded, mesh);
  const Edges other_edges = are_same ? Edges() : Edges(others, welded.points.size());
  const std::vector<Face>& faces = are_same ? welded.faces : others;
  const Edges& edges = are_same ? welded.edges : other_edges;
  Borders borders;
  BorderEdges border;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    const int sum = sum_along(faces, halfedges);
    if (sum == 0) continue;
    if (std::abs(sum) > 1) borders.is_oriented = false;
    const Face& f = faces[halfedges[0] / 3];
    const auto [low, high] = std::minmax(f[halfedges[0] % 3], f[(halfedges[0] % 3 + 1) % 3]);
    for (int i = 0; i < std::abs(sum); ++i) {
      border.emplace(sum > 0 ? low : high, sum > 0 ? high : low);
    }
  }
  borders.loops = walk(std::move(border));
  return borders;
}

Borders find_oriented_borders(const WeldedMesh& welded, const Mesh& mesh) {
  Borders borders = find_borders(welded, mesh);
  if (!borders.is_oriented && !is_oriented_by_indices(welded, mesh))
    refuse_orientation(welded, mesh);
  return borders;
}

bool is_stitched(const Mesh& mesh, const Borders& borders) {
  const ManifoldReport report = check_manifold(mesh);
  std::size_t border_edges = 0;
  for (const auto& loop : borders.loops) border_edges += loop.size();
  return report.is_manifold() && report.is_oriented() &&
         report.border_halfedges.size() == border_edges;
}

}  // namespace transformesh
