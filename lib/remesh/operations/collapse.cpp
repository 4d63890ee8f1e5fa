#include "remesh/operations/collapse.h"

#include <cmath>

#include "remesh/guards/edge_rules.h"
#include "remesh/halfedges/select_slots.h"
#include "remesh/operations/edge_collapser.h"
#include "remesh/operations/edge_queue.h"

namespace transformesh {
namespace {

/// Edges of up to this many times the shortest allowed length are collapsed if that makes valences
/// more regular. Larger values make more valences regular and more edges long.
constexpr double longest_irregular = 1.15;

/// The queue of edges to collapse, shortest first.
template <class Wanted>
class Candidates {
 public:
  Candidates(const EditableMesh& mesh, const Wanted& wanted) : mesh_(mesh), wanted_(wanted) {
    for (const Index h : wanted.all()) queue_.emplace(mesh, h);
  }

  bool empty() const { return queue_.empty(); }
  std::size_t size() const { return queue_.size(); }
  QueuedEdge pop() {
    const QueuedEdge edge = queue_.top();
    queue_.pop();
    return edge;
  }
  void push_around(Index vertex) {
    mesh_.for_each_neighbor(vertex, [&](Index, Index halfedge) { push(halfedge); });
  }

 private:
  void push(Index halfedge) {
    if (wanted_(halfedge)) queue_.emplace(mesh_, halfedge);
  }

  const EditableMesh& mesh_;
  const Wanted& wanted_;
  EdgeQueue<ShorterFirst> queue_;
};

template <class Wanted>
CollapseCounts collapse_wanted(EditableMesh& mesh, EdgeCollapser& collapser, Wanted& wanted,
                               const Progress& progress) {
  CollapseCounts counts;
  Candidates<Wanted> edges(mesh, wanted);
  const auto first = static_cast<double>(edges.size());
  for (double tried = 0; !edges.empty(); ++tried) {
    if (std::fmod(tried, 1024) == 0) progress("collapse", tried / (tried + first));
    const QueuedEdge edge = edges.pop();
    if (!edge.is_current(mesh) || !wanted(edge.halfedge)) continue;
    const Index vertex = collapser.collapse(edge.halfedge);
    if (vertex == no_index) {
      ++counts.refused;
    } else {
      ++counts.done;
      wanted.note_merged(vertex);
      edges.push_around(vertex);
    }
  }
  return counts;
}

/// Selects edges shorter than the least length.
class IsShort {
 public:
  IsShort(const EditableMesh& mesh, double min_edge, bool keep_border)
      : mesh_(mesh), limit_(min_edge * min_edge), keep_border_(keep_border) {}
  bool operator()(Index halfedge) const {
    return mesh_.scaled_squared_length(halfedge) < limit_ &&
           !(keep_border_ && mesh_.is_border(halfedge));
  }
  std::vector<Index> all() const {
    std::vector<Index> edges = edges_where(mesh_, [&](double squared) { return squared < limit_; });
    if (keep_border_) std::erase_if(edges, [&](Index h) { return mesh_.is_border(h); });
    return edges;
  }
  void note_merged(Index /*vertex*/) const {}

 private:
  const EditableMesh& mesh_;
  double limit_;
  bool keep_border_;
};

/// Selects edges that are not too long and whose collapse brings valences closer to six.
class IsIrregular {
 public:
  IsIrregular(const EditableMesh& mesh, double longest)
      : mesh_(mesh), limit_(longest * longest), excess_(mesh.vertex_slots(), -6) {
    for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
      if (!mesh.has_halfedge(h)) continue;
      ++excess_[mesh.source(h)];
      if (mesh.is_border(h))
        ++excess_[mesh.target(h)];  // a border vertex has one more edge than faces
    }
  }
  bool operator()(Index halfedge) const {
    return mesh_.scaled_squared_length(halfedge) < limit_ && !mesh_.is_border(halfedge) &&
           gain(halfedge) > 0;
  }
  // Tests valences before lengths, since few edges pass.
  std::vector<Index> all() const {
    return indices_where_in(mesh_.face_slots(), [&](Index face, std::vector<Index>& found) {
      if (!mesh_.has_face(face)) return;
      std::array<int, 3> excess;
      for (Index i = 0; i < 3; ++i) excess[i] = excess_[mesh_.source(3 * face + i)];
      for (Index i = 0; i < 3; ++i) {
        const Index h = 3 * face + i;
        const Index opposite = mesh_.opposite(h);
        if (opposite == no_index) continue;
        // The comparison of both halfedges is unpredictable for the processor, so it comes after
        // the test that rejects most edges.
        const int gained = gain(excess[i], excess[(i + 1) % 3], excess[(i + 2) % 3],
                                excess_[mesh_.apex(opposite)]);
        if (gained > 0 && h < opposite && mesh_.scaled_squared_length(h) < limit_)
          found.push_back(h);
      }
    });
  }
  void note_merged(Index vertex) {
    recount(vertex);
    mesh_.for_each_neighbor(vertex, [&](Index neighbor, Index) { recount(neighbor); });
  }

 private:
  void recount(Index vertex) { excess_[vertex] = static_cast<int>(mesh_.valence(vertex)) - 6; }
  int gain(Index halfedge) const {
    return gain(excess_[mesh_.source(halfedge)], excess_[mesh_.target(halfedge)],
                excess_[mesh_.apex(halfedge)], excess_[mesh_.apex(mesh_.opposite(halfedge))]);
  }
  /// The decrease of the sum of squared deviations from valence six. The arguments are the signed
  /// deviations before the collapse.
  static int gain(int source, int target, int left, int right) {
    const int merged = source + target + 2;
    // Each apex loses an edge, which decreases the sum by x^2 - (x - 1)^2 = 2x - 1.
    return source * source + target * target - merged * merged + 2 * left + 2 * right - 2;
  }

  const EditableMesh& mesh_;
  double limit_;
  std::vector<int> excess_;  ///< valence minus six
};

}  // namespace

CollapseCounts collapse_short_edges(EditableMesh& mesh, EmbeddingGuard& guard,
                                    const VertexRoles& roles, const EdgeLimits& limits,
                                    const Progress& progress) {
  EdgeCollapser collapser(mesh, guard, roles, limits.longest);
  collapser.keep_shape(limits.shape);
  IsShort is_short(mesh, limits.shortest, roles.keeps_border());
  CollapseCounts counts = collapse_wanted(mesh, collapser, is_short, progress);
  counts.films_kept = collapser.films_kept();
  if (counts.refused == 0) return counts;

  // An edge may have been refused several times, or may not exist any more.
  counts.refused = is_short.all().size();
  return counts;
}

std::size_t collapse_for_valence(EditableMesh& mesh, EmbeddingGuard& guard,
                                 const VertexRoles& roles, const EdgeLimits& limits,
                                 const Progress& progress) {
  EdgeCollapser collapser(mesh, guard, roles, limits.stretched());
  collapser.keep_shape(limits.shape);
  IsIrregular is_irregular(mesh, longest_irregular * limits.shortest);
  return collapse_wanted(mesh, collapser, is_irregular, progress).done;
}

bool collapse_edge(EditableMesh& mesh, EmbeddingGuard& guard, const VertexRoles& roles,
                   Index halfedge, const EdgeLimits& limits) {
  EdgeCollapser collapser(mesh, guard, roles, limits.longest);
  collapser.keep_shape(limits.shape);
  return collapser.collapse(halfedge) != no_index;
}

}  // namespace transformesh
