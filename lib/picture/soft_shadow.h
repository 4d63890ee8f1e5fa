/// The soft shadow of a mesh in the light of a lamp that is far away and seen from the mesh as a
/// disc of 8 degrees: how much of the lamp a point sees past the faces.
///
/// The mesh is seen from 48 places on the lamp, the same ones on every run, in pictures of depth of
/// 512x512; a point sees those places for which it is not behind a face there, by bilinear shares
/// (percentage-closer filtering). Points are lifted off their surface by up to two pixels of these
/// pictures, so that it does not shade itself: shadows in corners finer than 1/100 of the mesh's
/// size are not seen. References: Williams, "Casting curved shadows on curved surfaces", SIGGRAPH
/// 1978; Reeves, Salesin & Cook, "Rendering antialiased shadows with depth maps", SIGGRAPH 1987.
/// Cost: 48 rasterizations and 55 MB; parallel; the same for any number of threads.
#pragma once

#include <vector>

#include "raster/camera.h"
#include "transformesh/image.h"

namespace transformesh {

class SoftShadow {
 public:
  /// The direction towards the middle of the lamp has length 1.
  SoftShadow(const Mesh& mesh, const Vec3& towards_lamp);

  /// 0 to 1, of a point on a surface with that normal, of length 1, on the side that is seen. A
  /// point in the plane of a face that stands for a round surface is moved onto that beforehand
  /// (round_place), else its neighbors would shade it where light grazes.
  float share_seen(const Vec3& point, const Vec3& normal) const;

 private:
  struct Place {
    Camera camera;
    Raster<float> depths;  ///< infinite where there is no face
  };
  static float share_in_front(const Place& place, const Vec3& point);

  Vec3 towards_lamp_;
  double pixel_ = 0;  ///< its size at the mesh
  std::vector<Place> places_;
};

/// The point of a face, given by the weights of corners 0 and 1, on the smooth surface that corner
/// normals, of length 1, suggest, or in the face where that would lie behind it. Reference: Hanika,
/// "Hacking the shadow terminator", Ray Tracing Gems II, 2021.
Vec3 round_place(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals,
                 double weight_0, double weight_1);

}  // namespace transformesh
