/// Points beside faces at which the winding numbers of a mesh and of what was made from it can be
/// compared: nearer to the face than any other face of either, and outside the rounding zone.
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
  /// The input must be closed. The output was stored in numbers of the type `coordinate`. Keeps
  /// references.
  SampleFinder(const Mesh& input, const Mesh& output, const FaceMatch& match, Scalar coordinate);

  /// A sample in front of the face (side 1) or behind it (-1); nothing where no point will do.
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
