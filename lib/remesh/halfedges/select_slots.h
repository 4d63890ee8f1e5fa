/// Slots of an edited mesh that are in use, or satisfy a condition.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"
#include "support/parallel.h"

namespace transformesh {

/// Calls find(index, found) for all indices below `count`, which appends to `found`. Returns all
/// results in the order of the indices. `find` is called from several threads.
template <class Find>
std::vector<Index> indices_where_in(Index count, const Find& find) {
  constexpr std::size_t per_chunk = 4096;  // affects time only
  std::vector<std::vector<Index>> chunks((count + per_chunk - 1) / per_chunk);
  parallel_for(chunks.size(), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t chunk = from; chunk < to; ++chunk) {
      const std::size_t last = std::min<std::size_t>(count, (chunk + 1) * per_chunk);
      std::vector<Index> found;
      for (std::size_t i = chunk * per_chunk; i < last; ++i) find(static_cast<Index>(i), found);
      chunks[chunk] = std::move(found);
    }
  });
  std::vector<Index> result;
  for (const std::vector<Index>& chunk : chunks)
    result.insert(result.end(), chunk.begin(), chunk.end());
  return result;
}

/// Returns the indices below `count` for which is_wanted(index) is true, ascending.
template <class IsWanted>
std::vector<Index> indices_where(Index count, const IsWanted& is_wanted) {
  return indices_where_in(count, [&](Index i, std::vector<Index>& found) {
    if (is_wanted(i)) found.push_back(i);
  });
}

/// Returns the positions of all vertices that are not removed, in the order of their slots.
inline std::vector<Vec3> positions_of(const EditableMesh& mesh) {
  std::vector<Vec3> result;
  for (Index v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.has_vertex(v)) result.push_back(mesh.position(v));
  return result;
}

/// Returns the lower halfedges of the edges for whose scaled squared length is_wanted() is true.
/// The three lengths of a face are computed at once, which costs little more than one.
template <class IsWanted>
std::vector<Index> edges_where(const EditableMesh& mesh, const IsWanted& is_wanted) {
  return indices_where_in(mesh.face_slots(), [&](Index face, std::vector<Index>& found) {
    if (!mesh.has_face(face)) return;
    const std::array<double, 3> lengths = mesh.scaled_squared_lengths(face);
    for (Index i = 0; i < 3; ++i) {
      const Index h = 3 * face + i;
      if (is_wanted(lengths[i]) && h < mesh.opposite(h)) found.push_back(h);
    }
  });
}

}  // namespace transformesh
