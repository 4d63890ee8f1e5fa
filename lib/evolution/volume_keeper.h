/// Restores the volume of each component after cleaning and remeshing have changed it
/// (TimeOptions::keep_volume). Vertices move along the gradient of the volume. Their movement is in
/// proportion to their movement in the step, so that parts at rest stay in place. In a step in
/// which components merge or split, their common volume is restored. A cavity is a component with
/// negative volume.
#pragma once

#include <vector>

#include "transformesh/document.h"

namespace transformesh {

class VolumeKeeper {
 public:
  /// Call after the movement and before cleaning. Stores the volume of each component. Adds the
  /// number of each face's component as a face column, and the length of each vertex's movement as
  /// a vertex column. Cleaning and remeshing interpolate the latter.
  void begin(Mesh& mesh, const std::vector<Vec3>& displacements);

  /// Call after remeshing. Removes the columns and restores volumes, up to the rounding of the
  /// document's coordinates. Returns true if vertices moved; the mesh must then be cleaned again.
  /// Leaves a component unchanged if its vertices would have to move farther than a tenth of the
  /// mean edge, for example after surfaces have merged.
  bool restore(Document& document) const;

  /// Returns the sum of the volumes that begin() measured.
  double volume() const;

 private:
  std::vector<double> volumes_;  ///< volume of each component, in order of their first faces
};

/// Moves each vertex by `distance * weights[v]` along the gradient of the volume. `distance` is
/// chosen so that the mesh has the given volume up to rounding. Returns false and leaves the mesh
/// unchanged if no `distance` of at most `limit` is found. Cost: O(n).
bool move_to_volume(Mesh& mesh, double volume, const std::vector<double>& weights, double limit);

}  // namespace transformesh
