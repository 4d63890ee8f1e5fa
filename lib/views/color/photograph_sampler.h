/// Samples a photograph at points of a surface: returns the color of a point and the quality of
/// this observation.
/// Reference: Callieri, Cignoni, Corsini & Scopigno, "Masked photo blending: mapping dense
/// photographic data set on high-resolution sampled 3D models", Computers & Graphics 32(4), 2008.
/// The quality falls to zero towards contours of the surface and borders of the image, so that
/// blends of photographs have no seams there.
#pragma once

#include <vector>

#include "raster/camera.h"
#include "transformesh/image.h"
#include "transformesh/mesh.h"
#include "transformesh/pinhole_camera.h"
#include "views/color/best_view_colors.h"

namespace transformesh {

struct Place {
  Vec3 point;
  Vec3 normal;         ///< unit normal
  double spacing = 0;  ///< distance between sampled points; finer detail is averaged
};

class PhotographSampler {
 public:
  /// Renders the depths of the mesh in the camera. `pixel` is the length on the surface that
  /// corresponds to quality 1: the side of a pixel, projected onto a surface perpendicular to the
  /// viewing direction. Takes 11 bytes per pixel of `picture`.
  PhotographSampler(const Mesh& mesh, const PinholeCamera& camera, Image picture, double pixel);

  /// Returns the color of the point and the quality. The quality is 0 if the surface occludes the
  /// point, or if the camera is behind the surface or observes it at a grazing angle. It is also 0
  /// if the pixel is on a contour or on the border of the picture, and thus may show something
  /// else. Thread-safe.
  ViewColor at(const Place& place) const;

 private:
  Eigen::Array3f color_at(double x, double y, double spacing, int margin) const;

  Projection projection_;
  Vec3 center_;
  double focal_;
  double pixel_;
  /// The picture, then reduced pictures; each has half the width and height of the previous one.
  std::vector<Image> pyramid_;
  Raster<float> depth_;  ///< depth of the surface at each pixel; 0 for background
  /// For each pixel, the distance to the nearest contour or border, in pixels.
  Raster<std::uint8_t> margin_;
};

}  // namespace transformesh
