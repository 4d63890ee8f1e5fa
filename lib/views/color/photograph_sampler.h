/// Samples a photograph at points of a surface: returns the color of a point and its quality.
/// Reference: Callieri, Cignoni, Corsini & Scopigno, "Masked photo blending: mapping dense
/// photographic data set on high-resolution sampled 3D models", Computers & Graphics 32(4), 2008.
/// Quality falls to zero towards contours and borders, so that blends have no seams along them.
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
  /// `pixel` is the length of a pixel's side of quality 1. Takes 11 bytes per pixel.
  PhotographSampler(const Mesh& mesh, const PinholeCamera& camera, Image picture, double pixel);

  /// Returns quality 0 if the surface occludes the point, or if the point is observed from inside
  /// or at a grazing angle. The quality is also 0 if the pixel is on a contour or on the border of
  /// the picture, and thus may show something else. Thread-safe.
  ViewColor at(const Place& place) const;

 private:
  Eigen::Array3f color_at(double x, double y, double spacing, int margin) const;

  Projection projection_;
  Vec3 center_;
  double focal_;
  double pixel_;
  std::vector<Image> pyramid_;   ///< each has half the size of the one before
  Raster<float> depth_;          ///< 0 for background
  Raster<std::uint8_t> margin_;  ///< number of pixels to the nearest contour or border
};

}  // namespace transformesh
