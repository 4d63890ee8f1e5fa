/// Restores the volume after cleaning and remeshing have changed it (TimeOptions::keep_volume).
/// Vertices move along the gradient of the volume. Their movement is in proportion to their
/// movement in the step, so that parts at rest stay in place.
#pragma once

#include <vector>

#include "transformesh/document.h"

namespace transformesh {

class VolumeKeeper {
 public:
  /// Call after the movement and before cleaning. Stores the volume, and the length of each
  /// vertex's movement as a vertex column, which cleaning and remeshing interpolate.
  void begin(Mesh& mesh, const std::vector<Vec3>& displacements);

  /// Call after remeshing. Removes the column and restores the volume, up to the rounding of the
  /// document's coordinates. Returns true if vertices moved; the mesh must then be cleaned again.
  /// Leaves the mesh unchanged if vertices would have to move farther than a tenth of the mean
  /// edge, for example after a component has vanished.
  bool restore(Document& document) const;

  /// Returns the volume that begin() measured.
  double volume() const { return volume_; }

 private:
  double volume_ = 0;
};

/// Moves each vertex by `distance * weights[v]` along the gradient of the volume. `distance` is
/// chosen so that the mesh has the given volume up to rounding. Returns false and leaves the mesh
/// unchanged if no `distance` of at most `limit` is found. Cost: O(n).
bool move_to_volume(Mesh& mesh, double volume, const std::vector<double>& weights, double limit);

}  // namespace transformesh
