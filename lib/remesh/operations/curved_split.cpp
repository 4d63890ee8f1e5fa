#include "remesh/operations/curved_split.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "remesh/halfedges/select_slots.h"
#include "remesh/operations/curved_edge.h"
#include "remesh/operations/flip.h"
#include "remesh/operations/vertex_mover.h"

namespace transformesh {
namespace {

/// Largest number of rounds. A round halves every edge that is too long, so 64 rounds reduce an
/// edge from the largest extent of a mesh to the shortest edge that is split. More rounds would
/// only repeat refused splits.
constexpr int most_halvings = 64;
/// A new vertex may move from the middle of its edge to the curved surface if its triangles keep at
/// least this roundness. Other operations use the limit 0.6. Triangles that were halved twice are
/// less round than that, so their new vertices would stay off the curved surface. Values far below
/// 0.1 would allow slivers.
constexpr double round_enough_on_curve = 0.1;

/// The curved midpoints of the edges that are too long, by the ends of the edges. The midpoints are
/// computed before the splits, because splits put vertices on chords.
class CurvedMidpoints {
 public:
  CurvedMidpoints(const EditableMesh& mesh, double longest) {
    const double limit = longest * longest;
    const std::vector<Index> edges =
        edges_where(mesh, [&](double squared) { return squared > limit; });
    places_.reserve(edges.size());
    for (const Index h : edges)
      places_.push_back({ends_of(mesh.source(h), mesh.target(h)), curved_midpoint(mesh, h)});
    std::ranges::sort(places_, {}, &Place::ends);
  }

  bool empty() const { return places_.empty(); }
  /// Returns null for edges that were not too long.
  const Vec3* find(const std::array<Index, 2>& edge) const {
    const auto ends = ends_of(edge[0], edge[1]);
    const auto found = std::ranges::lower_bound(places_, ends, {}, &Place::ends);
    return found != places_.end() && found->ends == ends ? &found->position : nullptr;
  }

 private:
  using Ends = std::pair<Index, Index>;
  struct Place {
    Ends ends;
    Vec3 position;
  };
  static Ends ends_of(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

  std::vector<Place> places_;
};

void move_onto_curves(EditableMesh& mesh, Index first, const SafeSplits& splits,
                      const CurvedMidpoints& midpoints) {
  VertexMover mover(mesh, *splits.guard, round_enough_on_curve);
  VertexStar star;
  for (std::size_t i = 0; i < splits.ends.size(); ++i) {
    const Vec3* const place = midpoints.find(splits.ends[i]);
    const Index vertex = first + static_cast<Index>(i);
    if (place == nullptr || mesh.rounded(*place) == mesh.position(vertex)) continue;
    star.gather(mesh, vertex);
    mover.move(vertex, star, *place);
  }
}

}  // namespace

SafeSplits split_onto_curves(EditableMesh& mesh, SafeSplitOptions options, FlipRule rule,
                             const EdgeLimits& limits, std::size_t& flips,
                             const Progress& progress) {
  options.limits.only_given = true;
  SafeSplits all;
  for (int round = 0; round < most_halvings; ++round) {
    const CurvedMidpoints midpoints(mesh, options.limits.longest);
    if (midpoints.empty() && all.guard) break;
    const Index first = mesh.vertex_slots();
    SafeSplits splits = split_safely(mesh, options, progress);
    move_onto_curves(mesh, first, splits, midpoints);
    all.guard = std::move(splits.guard);
    all.done += splits.done;
    all.refused = splits.refused;
    if (splits.done == 0) break;
    flips += flip_edges(mesh, *all.guard, rule, limits, progress).done;
  }
  return all;
}

}  // namespace transformesh
