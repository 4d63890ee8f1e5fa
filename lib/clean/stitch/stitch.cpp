// Stitches a mesh (paper 3.3): joins vertices, optionally orients faces, pairs the halfedges at
// each edge, and duplicates singular vertices (3.3.1). Departure from the paper: an edge that is
// still singular after these steps is split at its midpoint (split_singular_edges.h). Cost: O(n log
// n). Deterministic.
#include "transformesh/stitch.h"

#include <algorithm>

#include "clean/exterior/angular_order.h"
#include "clean/stitch/double_sided.h"
#include "clean/stitch/orient.h"
#include "clean/stitch/orientation_check.h"
#include "clean/stitch/outward_bodies.h"
#include "clean/stitch/pair_halfedges.h"
#include "clean/stitch/split_border_edges.h"
#include "clean/stitch/split_singular_edges.h"
#include "clean/stitch/weld.h"
#include "mesh/drop_faces.h"
#include "mesh/separate_umbrellas.h"
#include "mesh/surface_columns.h"

namespace transformesh {
namespace {

// Joins vertices within the tolerance of each other: faces refer to only one of them afterwards.
// Returns the number of vertices that were replaced.
std::size_t join_vertices(Mesh& mesh, double tolerance) {
  const std::vector<Index> representative = weld_positions(mesh.positions, tolerance);
  for (Face& face : mesh.faces) {
    for (Index& v : face) v = representative[v];
  }
  std::size_t joined = 0;
  for (Index v = 0; v < representative.size(); ++v) joined += representative[v] != v ? 1 : 0;
  return joined;
}

std::size_t drop_collapsed_faces(Mesh& mesh) {
  std::vector<char> is_dropped;
  for (const Face& face : mesh.faces) is_dropped.push_back(is_collapsed(face) ? 1 : 0);
  return drop_faces(mesh, is_dropped);
}

// Counts border edges and misoriented edges. An edge with several unpaired halfedges is
// misoriented, because these halfedges have the same direction.
void count_open_edges(const Edges& edges, const std::vector<Index>& opposite,
                      StitchResult& result) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    const auto open = std::count_if(halfedges.begin(), halfedges.end(),
                                    [&](Index h) { return opposite[h] == no_index; });
    if (open == 1) ++result.border_edges;
    if (open > 1) ++result.misoriented_edges;
  }
}

std::vector<Index> pair_halfedges(const Mesh& mesh, const Edges& edges) {
  return pair_across_inside(mesh.faces, edges, [&](std::span<const Index> halfedges) {
    return sort_around_edge(mesh, halfedges);
  });
}

// Reverses bodies that are inside out if edges have more than two faces, before halfedges are
// paired. Otherwise faces on both sides of the outside would become neighbors, and bodies that
// touch would become one. Returns the number of reversed faces.
std::size_t turn_touching_bodies(Mesh& mesh) {
  Mesh apart{mesh.positions, mesh.faces, {}, {}};
  {
    const Edges edges(mesh);
    std::size_t e = 0;
    while (e < edges.size() && edges.halfedges(e).size() <= 2) ++e;
    if (e == edges.size()) return 0;
    separate_umbrellas(apart, find_umbrellas(mesh.faces, pair_halfedges(mesh, edges)));
  }
  const std::vector<Face> before = apart.faces;
  const std::size_t turned = turn_bodies_outwards(apart);
  for (Index f = 0; turned > 0 && f < before.size(); ++f) {
    if (apart.faces[f] == before[f]) continue;
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
    reverse_corner_lists(mesh, f);
  }
  return turned;
}

// Splits edges that still have more than two faces. A midpoint interpolates the columns of the ends
// of its edge; a new face gets the columns of the face from which it is cut.
std::size_t split_edges(Mesh& mesh, std::vector<Index>& opposite) {
  const EdgeSplits splits = split_singular_edges(mesh, opposite);
  for (const auto& [face, ends] : splits.vertices) {
    mesh.vertex_columns.append({{ends[0], ends[1], ends[1]}, {0.5, 0.5, 0}});
  }
  for (const Index face : splits.face_source) {
    mesh.face_columns.append({{face, face, face}, {1, 0, 0}});
  }
  return splits.edges;
}

// Splits border edges at T-junctions. New faces get the columns of the faces from which they are
// cut.
std::size_t split_borders(Mesh& mesh, double tolerance) {
  const BorderSplits splits = split_border_edges(mesh, tolerance);
  for (const Index face : splits.face_source)
    mesh.face_columns.append({{face, face, face}, {1, 0, 0}});
  return splits.edges;
}

}  // namespace

StitchResult stitch(Mesh& mesh, const StitchOptions& options) {
  StitchResult result;
  // Orient bodies that touch before their vertices are joined, because after joining they are not
  // separate components.
  if (options.outwards && !options.one_side) result.reversed_faces = turn_bodies_outwards(mesh);
  result.joined_vertices = join_vertices(mesh, options.tolerance);
  if (options.tolerance > 0) result.split_borders = split_borders(mesh, options.tolerance);
  if (options.one_side) result.dropped_reverses = drop_reverses(mesh);
  if (options.drop_copies) result.dropped_copies = drop_copies(mesh, options.orient);
  if (options.orient || options.one_side)
    result.reversed_faces += orient_faces(mesh, options.outwards);
  const std::vector<Face> all_faces = mesh.faces;
  result.dropped_faces = drop_collapsed_faces(mesh);

  if (options.outwards && !options.one_side) result.reversed_faces += turn_touching_bodies(mesh);

  const Edges edges(mesh);
  std::vector<Index> opposite = pair_halfedges(mesh, edges);
  count_open_edges(edges, opposite, result);
  if (result.misoriented_edges > 0) {
    const Mesh all{mesh.positions, all_faces, {}, {}};
    result.misorientation = describe_misorientation(all);
    result.can_be_oriented = can_be_oriented(all);
  }
  result.copied_vertices = separate_umbrellas(mesh, find_umbrellas(mesh.faces, opposite));
  result.split_edges = split_edges(mesh, opposite);
  if (options.one_side && options.outwards) {
    result.reversed_faces += turn_nested_alternately(mesh);
  } else if (options.one_side) {
    result.reversed_faces += turn_outwards(mesh);
  } else if (options.outwards) {
    result.reversed_faces += turn_bodies_outwards(mesh);
  }
  if (options.flip) reverse_faces(mesh);
  if (result.reversed_faces > 0) result.new_normals = refresh_normals(mesh);
  return result;
}

}  // namespace transformesh
