#include "remesh/operations/high_valence_collapse.h"

#include <algorithm>

#include "geometry/numbers/predicates.h"
#include "remesh/guards/edge_rules.h"
#include "remesh/halfedges/valences.h"
#include "remesh/operations/edge_collapser.h"
#include "remesh/operations/edge_queue.h"
#include "transformesh/intersect.h"

namespace transformesh {
namespace {

class StarThinner {
 public:
  StarThinner(EditableMesh& mesh, bool keep_border, const EdgeLimits& limits,
              std::vector<Index> valences)
      : mesh_(mesh),
        keep_border_(keep_border),
        roles_(mesh, keep_border),
        collapser_(mesh, roles_, limits.longest),
        limit_(limits.shortest * limits.shortest),
        valences_(std::move(valences)) {
    for (Index h = 0; h < mesh.halfedge_slots(); ++h)
      if (mesh.has_halfedge(h) && is_wanted(h)) queue_.emplace(mesh, h);
  }

  std::size_t run(const Progress& progress) {
    std::size_t done = 0;
    for (std::size_t tried = 0; !queue_.empty(); ++tried) {
      if (tried % 1024 == 0) progress("collapse");
      const QueuedEdge edge = queue_.top();
      queue_.pop();
      if (!edge.is_current(mesh_) || !is_wanted(edge.halfedge)) continue;
      done += collapse(edge.halfedge) ? 1 : 0;
    }
    return done;
  }

 private:
  bool is_crowded(Index vertex) const { return valences_[vertex] > usual_valence; }

  /// True if the edge is short, its opposite vertex has high valence, and neither of its ends has.
  bool is_wanted(Index h) const {
    const Index opposite = mesh_.opposite(h);
    return (is_crowded(mesh_.apex(h)) ||
            (opposite != no_index && is_crowded(mesh_.apex(opposite)))) &&
           !is_crowded(mesh_.source(h)) && !is_crowded(mesh_.target(h)) &&
           !(keep_border_ && opposite == no_index) && mesh_.scaled_squared_length(h) < limit_;
  }

  bool collapse(Index h) {
    const Index left = mesh_.apex(h), across = mesh_.opposite(h);
    const Index right = across == no_index ? no_index : mesh_.apex(across);
    const Index vertex = collapser_.collapse(h);
    if (vertex == no_index) return false;
    --valences_[left];
    if (right != no_index) --valences_[right];
    valences_[vertex] = mesh_.valence(vertex);
    // The edges at the vertex, and the edges opposite to the vertex, have new lengths or apexes.
    mesh_.for_each_outgoing(vertex, [&](Index outgoing) {
      for (const Index edge : {outgoing, next_halfedge(outgoing), previous_halfedge(outgoing)})
        if (is_wanted(edge)) queue_.emplace(mesh_, edge);
    });
    return true;
  }

  EditableMesh& mesh_;
  bool keep_border_;
  VertexRoles roles_;
  EdgeCollapser collapser_;
  double limit_;
  std::vector<Index> valences_;
  EdgeQueue<ShorterFirst> queue_;
};

}  // namespace

std::size_t collapse_high_valence_stars(EditableMesh& mesh, bool keep_border,
                                        const EdgeLimits& limits, const Progress& progress) {
  std::vector<Index> valences = valences_of(mesh);
  if (std::none_of(valences.begin(), valences.end(),
                   [](Index valence) { return valence > usual_valence; }))
    return 0;
  EditableMesh thinned = mesh;
  const std::size_t done =
      StarThinner(thinned, keep_border, limits, std::move(valences)).run(progress);
  const Mesh result = thinned.to_mesh();
  const bool is_sound =
      find_intersections(result, progress).empty() && degenerate_faces(result).empty();
  if (done == 0 || !is_sound) return 0;
  mesh = std::move(thinned);
  return done;
}

}  // namespace transformesh
