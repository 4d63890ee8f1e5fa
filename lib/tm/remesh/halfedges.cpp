#include "tm/remesh/halfedges.h"

#include <numeric>
#include <string>

#include "tm/support/counted.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr const char* advice = "; mend it with tm-stitch --orient";

void check_corners(std::span<const Index> sources, std::size_t vertices) {
  for (std::size_t h = 0; h < sources.size(); ++h) {
    if (sources[h] >= vertices) {
      throw InputError("face " + std::to_string(h / 3) + " has vertex index " +
                       std::to_string(sources[h]) + ", but " + there_are(vertices, "vertex"));
    }
  }
  for (Index h = 0; h < sources.size(); ++h) {
    if (sources[h] == sources[next_halfedge(h)]) {
      throw InputError("face " + std::to_string(h / 3) + " uses vertex " +
                       std::to_string(sources[h]) + " twice" + advice);
    }
  }
}

/// The halfedges that leave each vertex and where they arrive, as one array with offsets.
class Outgoing {
 public:
  struct End {
    Index halfedge;
    Index target;
  };

  Outgoing(std::span<const Index> sources, std::size_t vertices)
      : offsets_(vertices + 1, 0), ends_(sources.size()) {
    for (const Index source : sources) ++offsets_[source + 1];
    std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
    std::vector<Index> next(offsets_.begin(), offsets_.end() - 1);
    for (Index h = 0; h < sources.size(); ++h) {
      ends_[next[sources[h]]++] = {h, sources[next_halfedge(h)]};
    }
  }
  std::span<const End> operator[](Index vertex) const {
    return {ends_.data() + offsets_[vertex], ends_.data() + offsets_[vertex + 1]};
  }

 private:
  std::vector<Index> offsets_;
  std::vector<End> ends_;
};

bool has_equal_targets(std::span<const Outgoing::End> ends) {
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (ends[i].target == ends[j].target) return true;
    }
  }
  return false;
}

[[noreturn]] void throw_crowded_edge(std::span<const Index> sources, Index first, Index second) {
  throw InputError("faces " + std::to_string(first / 3) + " and " + std::to_string(second / 3) +
                   " run the same way along the edge from vertex " +
                   std::to_string(sources[first]) + " to vertex " +
                   std::to_string(sources[next_halfedge(first)]) +
                   ": the mesh is not an oriented manifold" + advice);
}

[[noreturn]] void throw_first_crowded_edge(std::span<const Index> sources,
                                           const Outgoing& outgoing) {
  for (Index h = 0;; ++h) {
    for (const auto& [other, target] : outgoing[sources[h]]) {
      if (other > h && target == sources[next_halfedge(h)]) throw_crowded_edge(sources, h, other);
    }
  }
}

}  // namespace

std::vector<Index> opposites_of(std::span<const Index> sources, std::size_t vertices) {
  check_corners(sources, vertices);
  std::vector<Index> opposites(sources.size(), no_index);
  const Outgoing outgoing(sources, vertices);
  for (Index v = 0; v < vertices; ++v) {
    if (has_equal_targets(outgoing[v])) throw_first_crowded_edge(sources, outgoing);
    for (const auto& [halfedge, target] : outgoing[v]) {
      if (target < v) continue;
      for (const auto& [other, back] : outgoing[target]) {
        if (back != v) continue;
        opposites[halfedge] = other;
        opposites[other] = halfedge;
      }
    }
  }
  return opposites;
}

}  // namespace transformesh
