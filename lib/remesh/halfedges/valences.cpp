#include "remesh/halfedges/valences.h"

#include <algorithm>

namespace transformesh {

std::vector<Index> valences_of(const EditableMesh& mesh) {
  std::vector<Index> valences(mesh.vertex_slots(), 0);
  for (Index h = 0; h < mesh.halfedge_slots(); ++h)
    if (mesh.has_halfedge(h)) ++valences[mesh.source(h)];
  return valences;
}

bool has_high_valence(const EditableMesh& mesh) {
  const std::vector<Index> valences = valences_of(mesh);
  return std::any_of(valences.begin(), valences.end(),
                     [](Index valence) { return valence > usual_valence; });
}

}  // namespace transformesh
