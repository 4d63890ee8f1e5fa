/// Runs edits in all slabs of a mesh (slabs.h), each with a guard of its own, and then what was
/// left over with the guard of the whole: what has moved out of its slab, or needs a new cell.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tm/remesh/embedding_guard.h"
#include "tm/support/progress.h"

namespace transformesh {

struct EditCounts {
  std::size_t done = 0;
  std::size_t refused = 0;

  void add(const EditCounts& other) {
    done += other.done;
    refused += other.refused;
  }
};

using Halfedges = std::vector<Index>;

/// The halfedges by the slab of their source, in the order given.
inline std::vector<Halfedges> sorted_by_slab(const EditableMesh& mesh, const Slabs& slabs,
                                             Halfedges halfedges) {
  std::vector<Halfedges> result(slabs.size());
  if (slabs.size() == 1) {
    result[0] = std::move(halfedges);
  } else {
    for (const Index h : halfedges) result[slabs.of(mesh.source(h))].push_back(h);
  }
  return result;
}

/// `edit(guard, indices, left)` edits what it may of the indices, puts the others into `left` and
/// returns its EditCounts. `indices_in(slab)` are those of a slab.
template <class IndicesIn, class Edit>
EditCounts edit_in_slabs(EmbeddingGuard& guard, const IndicesIn& indices_in, const Edit& edit) {
  const Slabs& slabs = guard.slabs();
  EditCounts counts;
  std::vector<Index> left;
  if (slabs.size() == 1) {
    counts.add(edit(guard, std::span<const Index>(indices_in(0)), left));
    return counts;
  }
  struct Part {
    std::unique_ptr<EmbeddingGuard> guard;
    std::vector<Index> left;
    EditCounts counts;
  };
  std::vector<Part> parts(slabs.size());
  slabs.for_each(
      [&](std::size_t slab) {
        Part& part = parts[slab];
        part.guard = std::make_unique<EmbeddingGuard>(guard, slabs[slab]);
        part.counts = edit(*part.guard, std::span<const Index>(indices_in(slab)), part.left);
      },
      [&](std::size_t slab) {
        guard.join(*parts[slab].guard);
        counts.add(parts[slab].counts);
        left.insert(left.end(), parts[slab].left.begin(), parts[slab].left.end());
      });
  std::vector<Index> none;
  counts.add(edit(guard, std::span<const Index>(left), none));
  return counts;
}

/// Moves all vertices: `make_move(guard)` makes a function of a vertex that says what came of it.
enum class Moved { not_wanted, done, refused };
template <class MakeMove>
EditCounts move_vertices(EmbeddingGuard& guard, const Progress& progress, const char* phase,
                         const MakeMove& make_move) {
  progress(phase, 0);
  const auto edit = [&](EmbeddingGuard& own, std::span<const Index> vertices,
                        std::vector<Index>& left) {
    EditCounts counts;
    auto move = make_move(own);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (i % 8192 == 8191 && !own.is_part())
        progress(phase, static_cast<double>(i) / static_cast<double>(vertices.size()));
      const bool may_edit = own.may_edit(vertices[i]);
      const Moved moved = may_edit ? move(vertices[i]) : Moved::refused;
      if (!may_edit || (own.was_put_off() && moved == Moved::refused)) {
        left.push_back(vertices[i]);
      } else {
        counts.done += moved == Moved::done ? 1 : 0;
        counts.refused += moved == Moved::refused ? 1 : 0;
      }
    }
    return counts;
  };
  return edit_in_slabs(
      guard, [&](std::size_t slab) -> const auto& { return guard.slabs().vertices(slab); }, edit);
}

}  // namespace transformesh
