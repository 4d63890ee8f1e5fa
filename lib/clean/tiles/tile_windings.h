/// Winding numbers of the reference points of tiles, counted while the faces of a closed mesh come
/// by in a stream. Exact; deterministic.
#pragma once

#include "clean/exterior/surroundings.h"
#include "geometry/axis_path.h"
#include "transformesh/measure.h"

namespace transformesh {

class TileWindings {
 public:
  /// A ray runs to infinity from each of several points of each box that is not empty.
  explicit TileWindings(const std::vector<Box>& boxes);

  /// Counts a face. Cost: O(log boxes), and O(1) for each ray in whose box the face lies.
  void add(const Triangle& triangle);
  /// Returns a point of a box, after all faces have come. Throws GoalError if every ray grazes an
  /// edge. Returns the origin for an empty box.
  ReferencePoint of_box(std::size_t box) const;

 private:
  struct Ray {
    Vec3 from;
    std::size_t box;
    AxisPath path;
  };
  std::vector<Ray> rays_;  ///< by y
  std::vector<char> is_empty_;
};

}  // namespace transformesh
