/// Finds points next to faces at which the winding numbers of input and output can be compared. The
/// points are closer to the face than to any other face of both meshes, and outside the
/// neighborhood in which rounding may have moved surfaces (rounding_zone.h). Cost: O(n log n) to
/// build; O(log n) per point tried on usual meshes.
#pragma once

#include <optional>

#include "clean/certify/certify_faces.h"
#include "clean/certify/rounding_zone.h"
#include "geometry/ray_cast_winding.h"

namespace transformesh {

struct WindingSample {
  Vec3 point = Vec3::Zero();
  int input_winding = 0;
  int output_winding = 0;
};

class SampleFinder {
 public:
  /// The input must be closed. `coordinate` is the type in which the output was stored. Keeps
  /// references to the meshes.
  SampleFinder(const Mesh& input, const Mesh& output, const FaceMatch& match, Scalar coordinate);

  /// Returns a sample in front of the face (side 1) or behind it (side -1), or nothing if no point
  /// is suitable.
  std::optional<WindingSample> find(const Mesh& mesh, Index face, int side) const;
  const RoundingZone& zone() const { return zone_; }

 private:
  std::optional<WindingSample> find_above(const Vec3& base, const Vec3& direction,
                                          double height) const;

  RayCastWinding input_winding_;
  RayCastWinding output_winding_;
  RoundingZone zone_;
};

}  // namespace transformesh
