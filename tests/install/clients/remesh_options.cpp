// Reads the defaults of the options and those for surfaces that a flow carries.
#include <transformesh/remesh_options.h>

using namespace transformesh;

int main() {
  const RemeshOptions usual, curved = curved_remeshing();
  if (usual.curved || usual.min_film != 0 || usual.pinch != 0) return 1;
  if (usual.smoothing != Smoothing::tangential || usual.flip != FlipRule::valence) return 1;
  return curved.curved && curved.smoothing == Smoothing::none && curved.flip == FlipRule::angle ? 0
                                                                                                : 1;
}
