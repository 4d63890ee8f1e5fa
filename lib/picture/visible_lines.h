/// Which parts of lines an eye sees: hidden-line removal, exactly and not by pixels.
///
/// A face hides what lies in the cone from the eye through it, beyond its plane: for a segment that
/// is where four linear functions are positive, one interval. Faces that are behind a point by less
/// than 1e-6 of its distance do not hide it, so that lines on a surface show.
/// Reference: Appel, "The notion of quantitative invisibility and the machine rendering of solids",
/// ACM National Conference 1967; here the faces before a line come from a Bvh of their images.
/// Cost: O(faces) to build, O(log faces + boxes that overlap) a segment. Deterministic; safe to
/// call from several threads at once.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/search/bvh.h"
#include "raster/camera.h"
#include "raster/rasterize.h"
#include "transformesh/mesh.h"

namespace transformesh {

class VisibleLines {
 public:
  /// Keeps a reference to neither. Faces of any orientation hide.
  VisibleLines(const Mesh& mesh, const Camera& camera);

  /// The parts of the segment inside the image that no face hides but for those in `own`, in which
  /// it lies: places in [0, 1] from its start to its end, ascending and apart.
  using Parts = std::vector<std::pair<double, double>>;
  Parts parts(const Vec3& from, const Vec3& to, std::span<const Index> own = {}) const;

 private:
  Camera camera_;
  std::vector<EdgeFunctions> faces_;
  Bvh bvh_;  ///< of pixels, and distances along the axis
};

}  // namespace transformesh
