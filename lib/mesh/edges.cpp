#include "mesh/edges.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "support/parallel.h"
#include "transformesh/control.h"

namespace transformesh {
namespace {

/// A halfedge in the bucket of its smaller vertex. The larger vertex occupies the upper bits and
/// the halfedge the lower bits, so that sorted integers are sorted by both.
using Entry = std::uint64_t;
static_assert(2 * sizeof(Index) == sizeof(Entry));
constexpr int index_bits = 32;  ///< bits of an index
constexpr Entry entry_of(Index larger, Index halfedge) {
  return Entry{larger} << index_bits | halfedge;
}
constexpr Index larger_vertex(Entry entry) { return static_cast<Index>(entry >> index_bits); }
constexpr Index halfedge_of(Entry entry) { return static_cast<Index>(entry); }

constexpr std::size_t edges_per_task = 8192;   ///< affects time only
constexpr std::size_t faces_per_block = 4096;  ///< affects time only
/// The vertices are divided into this number of parts per thread. A choice: more parts balance the
/// threads better, but more blocks of faces have vertices in two parts.
constexpr std::size_t parts_per_thread = 4;

/// A range of vertices with their buckets, which one thread fills and sorts.
struct Part {
  Index first = 0, last = 0;    ///< the vertices from `first` to before `last`
  std::size_t first_entry = 0;  ///< index of the first entry of its buckets among all entries
  std::size_t entries = 0;      ///< number of entries in its buckets
  std::size_t first_edge = 0;   ///< index of its first edge among all edges
  std::size_t edges = 0;        ///< number of edges in its buckets
};

/// For a block of faces: the smallest and the largest of the vertices in whose buckets its
/// halfedges are.
struct VertexRange {
  Index first = no_index, last = 0;
  bool overlaps(const Part& part) const { return first < part.last && last >= part.first; }
};

/// Calls visit(smaller vertex, larger vertex, halfedge) for the faces from `first` to before
/// `last`, in order of the halfedges.
template <class Visit>
void for_each_halfedge(std::span<const Face> faces, std::size_t first, std::size_t last,
                       const Visit& visit) {
  auto halfedge = static_cast<Index>(3 * first);
  for (std::size_t f = first; f < last; ++f) {
    const Face& face = faces[f];
    for (int corner = 0; corner < 3; ++corner, ++halfedge) {
      const Index source = face[corner];
      const Index target = face[corner == 2 ? 0 : corner + 1];
      if (source != target) visit(std::min(source, target), std::max(source, target), halfedge);
    }
  }
}

/// Buckets have three entries on average; insertion sort is the fastest for so few.
void sort_bucket(Entry* first, Entry* last) {
  if (last - first > 32) return std::sort(first, last);
  for (Entry* entry = first; entry != last; ++entry) {
    const Entry moving = *entry;
    Entry* slot = entry;
    for (; slot != first && moving < slot[-1]; --slot) *slot = slot[-1];
    *slot = moving;
  }
}

/// Counting sort by the smaller vertex, in parts of the vertices. Each part visits the blocks of
/// faces that have one of its vertices. In meshes whose faces are in spatial order, these are few.
class Buckets {
 public:
  Buckets(std::span<const Face> faces, std::size_t vertices);
  std::size_t entry_count() const { return parts_.back().first_entry + parts_.back().entries; }
  /// Writes the halfedges of all edges, edge by edge. Returns the index of each edge's first
  /// halfedge in `halfedges`.
  RawVector<Index> sort(std::span<Index> halfedges);

 private:
  void find_ranges();
  template <class Visit>
  void for_each_halfedge_of(const Part& part, const Visit& visit) const;
  template <class Body>
  void for_each_part(const Body& body);
  void count(Part& part);
  void fill(const Part& part);
  void sort(Part& part, std::span<Index> halfedges, std::span<Index> offsets);

  std::span<const Face> faces_;
  std::vector<Part> parts_;
  std::vector<VertexRange> ranges_;  ///< one for each block of faces; empty if there is one part
  RawVector<Index> bucket_end_;      ///< for each vertex the end of the filled part of its bucket
  RawVector<Entry> entries_;
};

Buckets::Buckets(std::span<const Face> faces, std::size_t vertices)
    : faces_(faces), bucket_end_(vertices) {
  const std::size_t threads = faces.size() > faces_per_block ? allowed_thread_count() : 1;
  parts_.resize(threads == 1 ? 1 : threads * parts_per_thread);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    parts_[p].first = static_cast<Index>(p * vertices / parts_.size());
    parts_[p].last = static_cast<Index>((p + 1) * vertices / parts_.size());
  }
  if (parts_.size() > 1) find_ranges();
  for_each_part([&](Part& part) { count(part); });
  for (std::size_t p = 1; p < parts_.size(); ++p)
    parts_[p].first_entry = parts_[p - 1].first_entry + parts_[p - 1].entries;
  entries_.resize(entry_count());
}

template <class Body>
void Buckets::for_each_part(const Body& body) {
  parallel_for(parts_.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) body(parts_[p]);
  });
}

void Buckets::find_ranges() {
  ranges_.resize((faces_.size() + faces_per_block - 1) / faces_per_block);
  parallel_for(ranges_.size(), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t b = from; b < to; ++b) {
      VertexRange range;
      const std::size_t last = std::min(faces_.size(), (b + 1) * faces_per_block);
      for_each_halfedge(faces_, b * faces_per_block, last, [&](Index smaller, Index, Index) {
        range.first = std::min(range.first, smaller);
        range.last = std::max(range.last, smaller);
      });
      ranges_[b] = range;
    }
  });
}

template <class Visit>
void Buckets::for_each_halfedge_of(const Part& part, const Visit& visit) const {
  if (parts_.size() == 1) return for_each_halfedge(faces_, 0, faces_.size(), visit);
  const Index vertices = part.last - part.first;
  for (std::size_t b = 0; b < ranges_.size(); ++b) {
    if (!ranges_[b].overlaps(part)) continue;
    const std::size_t last = std::min(faces_.size(), (b + 1) * faces_per_block);
    for_each_halfedge(faces_, b * faces_per_block, last,
                      [&](Index smaller, Index larger, Index halfedge) {
                        if (smaller - part.first < vertices) visit(smaller, larger, halfedge);
                      });
  }
}

void Buckets::count(Part& part) {
  std::fill(bucket_end_.begin() + part.first, bucket_end_.begin() + part.last, 0);
  for_each_halfedge_of(part, [&](Index smaller, Index, Index) { ++bucket_end_[smaller]; });
  part.entries = std::accumulate(bucket_end_.begin() + part.first, bucket_end_.begin() + part.last,
                                 std::size_t{0});
}

void Buckets::fill(const Part& part) {
  auto begin = static_cast<Index>(part.first_entry);
  for (Index v = part.first; v < part.last; ++v) begin += std::exchange(bucket_end_[v], begin);
  for_each_halfedge_of(part, [&](Index smaller, Index larger, Index halfedge) {
    entries_[bucket_end_[smaller]++] = entry_of(larger, halfedge);
  });
}

// Sorts each bucket by the larger vertex; a new edge starts at each change of that vertex.
void Buckets::sort(Part& part, std::span<Index> halfedges, std::span<Index> offsets) {
  auto first = static_cast<Index>(part.first_entry);
  Index* next_offset = offsets.data() + part.first_entry;
  for (Index v = part.first; v < part.last; ++v) {
    const Index last = bucket_end_[v];
    sort_bucket(entries_.data() + first, entries_.data() + last);
    for (Index i = first; i < last; ++i) {
      if (i == first || larger_vertex(entries_[i]) != larger_vertex(entries_[i - 1]))
        *next_offset++ = i;
      halfedges[i] = halfedge_of(entries_[i]);
    }
    first = last;
  }
  part.edges = static_cast<std::size_t>(next_offset - offsets.data()) - part.first_entry;
}

RawVector<Index> Buckets::sort(std::span<Index> halfedges) {
  RawVector<Index> offsets(halfedges.size() + 1);
  for_each_part([&](Part& part) {
    fill(part);
    sort(part, halfedges, offsets);
  });
  std::size_t edges = 0;
  for (Part& part : parts_) part.first_edge = std::exchange(edges, edges + part.edges);
  if (parts_.size() > 1) {
    RawVector<Index> joined(edges + 1);
    for_each_part([&](const Part& part) {
      std::copy_n(offsets.begin() + static_cast<std::ptrdiff_t>(part.first_entry), part.edges,
                  joined.begin() + static_cast<std::ptrdiff_t>(part.first_edge));
    });
    offsets.swap(joined);
  }
  offsets.resize(edges);
  offsets.push_back(static_cast<Index>(halfedges.size()));
  return offsets;
}

}  // namespace

Edges::Edges(std::span<const Face> faces, std::size_t vertices) {
  Buckets buckets(faces, vertices);
  halfedges_.resize(buckets.entry_count());
  offsets_ = buckets.sort(halfedges_);
}

std::vector<Index> neighbors_across(const Edges& edges, std::size_t faces) {
  std::vector<Index> across(3 * faces, no_index);
  parallel_for(edges.size(), edges_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) {
      const auto halfedges = edges.halfedges(e);
      if (halfedges.size() != 2) continue;
      across[halfedges[0]] = halfedges[1];
      across[halfedges[1]] = halfedges[0];
    }
  });
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
