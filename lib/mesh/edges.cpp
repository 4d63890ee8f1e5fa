#include "mesh/edges.h"

#include <algorithm>
#include <cstdint>

namespace transformesh {
namespace {

/// A halfedge in the bucket of its smaller vertex. The larger vertex occupies the upper bits and
/// the halfedge the lower ones, so that integers sort by both.
using Entry = std::uint64_t;
static_assert(2 * sizeof(Index) == sizeof(Entry));
constexpr int index_bits = 32;  ///< bits of an index
constexpr Entry entry_of(Index larger, Index halfedge) {
  return Entry{larger} << index_bits | halfedge;
}
constexpr Index larger_vertex(Entry entry) { return static_cast<Index>(entry >> index_bits); }
constexpr Index halfedge_of(Entry entry) { return static_cast<Index>(entry); }

/// Calls visit(smaller vertex, larger vertex, halfedge) in order of the halfedges.
template <class Visit>
void for_each_halfedge(std::span<const Face> faces, const Visit& visit) {
  Index halfedge = 0;
  for (const Face& face : faces) {
    for (int corner = 0; corner < 3; ++corner, ++halfedge) {
      const Index source = face[corner];
      const Index target = face[corner == 2 ? 0 : corner + 1];
      if (source != target) visit(std::min(source, target), std::max(source, target), halfedge);
    }
  }
}

/// Buckets have three entries on average; insertion sort is the fastest for these.
void sort_bucket(Entry* first, Entry* last) {
  if (last - first > 32) return std::sort(first, last);
  for (Entry* entry = first; entry != last; ++entry) {
    const Entry moving = *entry;
    Entry* slot = entry;
    for (; slot != first && moving < slot[-1]; --slot) *slot = slot[-1];
    *slot = moving;
  }
}

}  // namespace

Edges::Edges(std::span<const Face> faces, std::size_t vertices) {
  // Counting sort by the smaller vertex.
  std::vector<Index> bucket_end(vertices + 1, 0);
  for_each_halfedge(faces, [&](Index smaller, Index, Index) { ++bucket_end[smaller + 1]; });
  for (std::size_t v = 1; v < bucket_end.size(); ++v) bucket_end[v] += bucket_end[v - 1];
  std::vector<Entry> entries(bucket_end.back());
  for_each_halfedge(faces, [&](Index smaller, Index larger, Index halfedge) {
    entries[bucket_end[smaller]++] = entry_of(larger, halfedge);
  });

  // Sort each bucket by the larger vertex; a new edge starts at each change of that vertex.
  halfedges_.resize(entries.size());
  offsets_.clear();
  offsets_.reserve(entries.size() / 2 + 2);
  Index first = 0;
  for (std::size_t v = 0; v + 1 < bucket_end.size(); ++v) {
    const Index last = bucket_end[v];
    sort_bucket(entries.data() + first, entries.data() + last);
    for (Index i = first; i < last; ++i) {
      if (i == first || larger_vertex(entries[i]) != larger_vertex(entries[i - 1]))
        offsets_.push_back(i);
      halfedges_[i] = halfedge_of(entries[i]);
    }
    first = last;
  }
  offsets_.push_back(first);
}

std::vector<Index> neighbors_across(const Edges& edges, std::size_t faces) {
  std::vector<Index> across(3 * faces, no_index);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() != 2) continue;
    across[halfedges[0]] = halfedges[1];
    across[halfedges[1]] = halfedges[0];
  }
  return across;
}

std::vector<Face> without_collapsed(std::span<const Face> faces) {
  std::vector<Face> result(faces.begin(), faces.end());
  for (Face& face : result) {
    if (is_collapsed(face)) face.fill(face[0]);
  }
  return result;
}

}  // namespace transformesh
