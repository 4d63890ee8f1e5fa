/// Restores the volume that cleaning and remeshing change (TimeOptions::keep_volume). Vertices move
/// along the gradient of the volume, in proportion to how far the motion carried them: parts at
/// rest stay where they are.
#pragma once

#include <vector>

#include "transformesh/document.h"

namespace transformesh {

class VolumeKeeper {
 public:
  /// Call after the motion and before cleaning. Stores how far each vertex moved in a vertex
  /// column, which cleaning and remeshing carry, and remembers the volume.
  void begin(Mesh& mesh, const std::vector<Vec3>& displacements);

  /// Call after remeshing. Removes the column and restores the volume, up to the rounding of the
  /// document's coordinates. Returns true if vertices moved: clean() is due then. Leaves the mesh
  /// unchanged if vertices would have to move farther than a tenth of the mean edge, as after a
  /// component has vanished.
  bool restore(Document& document) const;

  /// The volume that begin() found.
  double volume() const { return volume_; }

 private:
  double volume_ = 0;
};

/// Moves each vertex by `distance * weights[v]` along the gradient of the volume, where `distance`
/// is such that the mesh has this volume up to rounding. Returns false and leaves the mesh
/// unchanged if no `distance` of at most `limit` is found. Cost: O(n).
bool move_to_volume(Mesh& mesh, double volume, const std::vector<double>& weights, double limit);

}  // namespace transformesh
