/// Soft shadows of a mesh in the light of a distant lamp, which appears from the mesh as a disc of
/// 8 degrees.
/// References: Williams, "Casting curved shadows on curved surfaces", SIGGRAPH 1978; Reeves,
/// Salesin & Cook, "Rendering antialiased shadows with depth maps", SIGGRAPH 1987.
///
/// Depth images of 512x512 pixels are rendered from 48 positions on the lamp, which are the same in
/// every run. A position lights a point if no face is in front of the point in its depth image. The
/// results of four pixels are interpolated (percentage-closer filtering). Points are lifted off the
/// surface by up to two pixels of these images, so that the surface does not shadow itself. Hence
/// shadows in corners finer than 1/100 of the size of the mesh are missing. Cost: 48 rasterizations
/// and 55 MB. Parallel; the result does not depend on the number of threads.
#pragma once

#include <vector>

#include "raster/camera.h"
#include "transformesh/image.h"

namespace transformesh {

class SoftShadow {
 public:
  /// `towards_lamp` is the unit vector towards the center of the lamp.
  SoftShadow(const Mesh& mesh, const Vec3& towards_lamp);

  /// Returns the fraction of the lamp that lights a point, 0 to 1. `normal` is the unit normal of
  /// the surface on the visible side. If a face approximates a round surface, move the point with
  /// round_place() first. Otherwise adjacent faces would shadow it at grazing incidence.
  float share_seen(const Vec3& point, const Vec3& normal) const;

 private:
  struct Place {
    Camera camera;
    Raster<float> depths;  ///< infinite at pixels without a face
  };
  static float share_in_front(const Place& place, const Vec3& point);

  Vec3 towards_lamp_;
  double pixel_ = 0;  ///< size of a pixel at the mesh
  std::vector<Place> places_;
};

/// Moves a point of a face to the smooth surface that the corner normals suggest. The point stays
/// in the face if the smooth surface would be behind it. `normals` have length 1; the point is
/// given by the weights of corners 0 and 1.
/// Reference: Hanika, "Hacking the shadow terminator", Ray Tracing Gems II, 2021.
Vec3 round_place(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals,
                 double weight_0, double weight_1);

}  // namespace transformesh
