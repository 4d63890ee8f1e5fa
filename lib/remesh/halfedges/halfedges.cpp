#include "remesh/halfedges/halfedges.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "mesh/edges.h"
#include "mesh/location_text.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

bool has_good_corners(const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  return std::all_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& face) {
    return face[0] < count && face[1] < count && face[2] < count && !is_collapsed(face);
  });
}

void check_corners(const Mesh& mesh) {
  if (has_good_corners(mesh)) return;
  const auto halfedges = static_cast<Index>(3 * mesh.faces.size());
  for (Index h = 0; h < halfedges; ++h) {
    const Index vertex = halfedge_source(mesh, h);
    if (vertex >= mesh.positions.size()) {
      throw InputError("face " + std::to_string(h / 3) + " has vertex index " +
                       std::to_string(vertex) + ", but " +
                       there_are(mesh.positions.size(), "vertex"));
    }
  }
  for (Index h = 0; h < halfedges; ++h) {
    const Index vertex = halfedge_source(mesh, h);
    if (vertex == halfedge_target(mesh, h)) {
      throw InputError(
          ErrorKind::not_manifold,
          "face " + std::to_string(h / 3) + " uses vertex " + std::to_string(vertex) + " twice",
          {.faces = {h / 3}});
    }
  }
}

[[noreturn]] void refuse_alike(const Mesh& mesh, Index first, Index second) {
  ErrorData data = edge_data(mesh, first);
  data.faces.push_back(second / 3);
  throw InputError(ErrorKind::not_manifold,
                   "faces " + std::to_string(first / 3) + " and " + std::to_string(second / 3) +
                       " traverse the edge from vertex " +
                       std::to_string(halfedge_source(mesh, first)) + " to vertex " +
                       std::to_string(halfedge_target(mesh, first)) +
                       " in the same direction: the mesh is not an oriented manifold",
                   std::move(data));
}

/// The opposites of an oriented manifold, found in one pass over the halfedges. Returns nothing if
/// an edge has two halfedges of the same direction or three halfedges, or if vertices have so many
/// edges that the search would take long. Pre: has_good_corners().
std::optional<std::vector<Index>> quick_opposites(const Mesh& mesh) {
  struct Waiting {
    Index larger;  ///< the larger vertex of the edge
    Index next;    ///< next halfedge in the list of the smaller vertex
  };
  constexpr std::size_t usual_steps = 16;  // per halfedge, on average
  const auto halfedges = static_cast<Index>(3 * mesh.faces.size());
  std::size_t steps_left = usual_steps * halfedges;
  std::vector<Index> first_at(mesh.positions.size(), no_index);
  std::vector<Waiting> waiting(halfedges);
  std::vector<Index> opposites(halfedges, no_index);
  for (Index h = 0; h < halfedges; ++h) {
    const Index source = halfedge_source(mesh, h);
    const Index target = halfedge_target(mesh, h);
    const Index larger = std::max(source, target);
    Index& first = first_at[std::min(source, target)];
    Index other = first;
    for (; other != no_index && waiting[other].larger != larger; other = waiting[other].next)
      if (--steps_left == 0) return std::nullopt;
    if (other == no_index) {
      waiting[h] = {larger, first};
      first = h;
      continue;
    }
    if (opposites[other] != no_index || halfedge_source(mesh, other) == source) return std::nullopt;
    opposites[h] = other;
    opposites[other] = h;
  }
  return opposites;
}

/// The lowest two halfedges with the same direction along an edge, or no_index twice.
std::pair<Index, Index> find_alike(const Mesh& mesh, const Edges& edges) {
  std::pair<Index, Index> lowest{no_index, no_index};
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() == 2 &&
        halfedge_source(mesh, halfedges[0]) != halfedge_source(mesh, halfedges[1]))
      continue;
    for (auto h = halfedges.begin(); h != halfedges.end(); ++h) {
      const auto other = std::find_if(h + 1, halfedges.end(), [&](Index o) {
        return halfedge_source(mesh, o) == halfedge_source(mesh, *h);
      });
      if (other != halfedges.end()) lowest = std::min(lowest, {*h, *other});
    }
  }
  return lowest;
}

}  // namespace

std::vector<Index> manifold_opposites(const Mesh& mesh) {
  check_corners(mesh);
  if (auto opposites = quick_opposites(mesh)) return *std::move(opposites);
  const Edges edges(mesh);
  const auto [first, second] = find_alike(mesh, edges);
  if (first != no_index) refuse_alike(mesh, first, second);
  return neighbors_across(edges, mesh.faces.size());
}

}  // namespace transformesh
