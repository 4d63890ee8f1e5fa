/// Finds a reference point (a point with known winding number) in each of several boxes, in one
/// pass over the faces of a closed mesh. Exact; deterministic.
#pragma once

#include "clean/exterior/surroundings.h"
#include "geometry/axis_path.h"
#include "transformesh/measure.h"

namespace transformesh {

class TileWindings {
 public:
  /// Starts rays to infinity from several points of each nonempty box.
  explicit TileWindings(const std::vector<Box>& boxes);

  /// Adds a face. Cost: O(log b) for b boxes, and O(1) for each ray whose start is in the y range
  /// of the face.
  void add(const Triangle& triangle);
  /// Returns a point in a box with its winding number, after all faces are added. Throws GoalError
  /// if every ray of the box touches an edge. Returns the point (0, 0, 0) with winding number 0 for
  /// an empty box.
  ReferencePoint of_box(std::size_t box) const;

 private:
  struct Ray {
    Vec3 from;
    std::size_t box;
    AxisPath path;
  };
  std::vector<Ray> rays_;  ///< rays, sorted by the y coordinate of their starts
  std::vector<char> is_empty_;
};

}  // namespace transformesh
