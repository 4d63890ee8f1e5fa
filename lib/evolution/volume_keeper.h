/// Restores the volume that cleaning and remeshing change (TimeOptions::keep_volume). Vertices move
/// along the gradient of the volume, in proportion to how far the motion carried them: parts at
/// rest stay where they are.
#pragma once

#include <vector>

#include "evolution/loop/stages.h"

namespace transformesh {

class VolumeKeeper {
 public:
  /// Call after the motion and before cleaning. Stores how far each vertex moved in a vertex
  /// column, which cleaning and remeshing carry, and remembers the volume.
  void begin(Mesh& mesh, const std::vector<Vec3>& displacements);

  /// Call after remeshing. Removes the column and restores the volume, then cleans again. Leaves
  /// the mesh unchanged if vertices would have to move farther than a tenth of the mean edge, as
  /// after a component has vanished. Returns the difference of volume that remains.
  double restore(Document& document, const IterationOptions& options, const Progress& progress);

 private:
  double volume_ = 0;
};

/// Moves each vertex by `distance * weights[v]` along the gradient of the volume, where `distance`
/// is such that the mesh has this volume up to rounding. Returns false and leaves the mesh
/// unchanged if no `distance` of at most `limit` is found. Cost: O(n).
bool move_to_volume(Mesh& mesh, double volume, const std::vector<double>& weights, double limit);

}  // namespace transformesh
