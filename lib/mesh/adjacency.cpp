#include "mesh/adjacency.h"

#include <algorithm>
#include <atomic>

#include "support/numbered_selection.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t things_per_task = 8192;  ///< affects time only

/// Calls visit(vertex) once for each distinct vertex of the face.
template <class Visit>
void for_each_distinct_corner(const Face& face, const Visit& visit) {
  visit(face[0]);
  if (face[1] != face[0]) visit(face[1]);
  if (face[2] != face[0] && face[2] != face[1]) visit(face[2]);
}

/// True if the faces at each vertex form a single umbrella. Pre: every halfedge has an opposite.
/// Walks around each vertex once, from any of its halfedges. These walks reach all halfedges only
/// if no vertex has a second umbrella.
bool has_single_umbrellas(const Mesh& mesh, std::span<const Index> opposites) {
  std::vector<Index> outgoing(mesh.positions.size(), no_index);
  parallel_for(mesh.faces.size(), things_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      for (std::size_t i = 0; i < 3; ++i)
        std::atomic_ref(outgoing[mesh.faces[f][i]])
            .store(static_cast<Index>(3 * f + i), std::memory_order_relaxed);
  });
  std::atomic<std::size_t> reached = 0;
  parallel_for(outgoing.size(), things_per_task, [&](std::size_t first, std::size_t last) {
    std::size_t count = 0;
    for (std::size_t v = first; v < last; ++v) {
      if (outgoing[v] == no_index) continue;
      Index h = outgoing[v];
      do {
        h = opposites[previous_halfedge(h)];
        ++count;
      } while (h != outgoing[v]);
    }
    reached += count;
  });
  return reached == opposites.size();
}

}  // namespace

bool is_closed_manifold(const Mesh& mesh, std::span<const Index> opposites) {
  const bool is_closed = NumberedSelection(opposites.size(), [&](std::size_t h) {
                           return opposites[h] == no_index;
                         }).size() == 0;
  return is_closed && has_single_umbrellas(mesh, opposites);
}

std::optional<std::vector<Index>> closed_opposites(const Mesh& mesh, std::vector<Index> opposites) {
  if (!is_closed_manifold(mesh, opposites)) return std::nullopt;
  return opposites;
}

std::vector<Index> opposite_halfedges(const Mesh& mesh) {
  std::vector<Index> opposite = neighbors_across(Edges(mesh), mesh.faces.size());
  for (Index h = 0; h < opposite.size(); ++h) {
    const Index other = opposite[h];
    if (other != no_index && halfedge_source(mesh, h) == halfedge_source(mesh, other))
      opposite[h] = opposite[other] = no_index;
  }
  return opposite;
}

VertexFaces::VertexFaces(const Mesh& mesh) : offsets_(mesh.positions.size() + 2, 0) {
  // A counting sort. Counts are shifted by one slot, so that the offsets are correct after filling.
  for (const Face& face : mesh.faces)
    for_each_distinct_corner(face, [&](Index vertex) { ++offsets_[vertex + 2]; });
  for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
  faces_.resize(offsets_.back());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for_each_distinct_corner(mesh.faces[f], [&](Index vertex) {
      faces_[offsets_[vertex + 1]++] = static_cast<Index>(f);
    });
}

}  // namespace transformesh
