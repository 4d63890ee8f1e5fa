/// The part of a surface that is visible in one view, with all values of pixels that are needed for
/// comparing views.
#pragma once

#include "raster/rasterize.h"
#include "views/cameras/view.h"
#include "views/photo/visible_depths.h"

namespace transformesh {

/// Values for each pixel of `box`, the rectangle of the view that shows the surface. `depth` and
/// `inverse_facing` are 0 at pixels that are not compared.
struct VisibleSurface {
  PixelBox box;
  FaceBuffer faces;
  /// Depth of the compared pixels. A pixel is compared if it shows the front of a face, and if the
  /// cosine between viewing ray and normal is at least `least_cosine`.
  GrayImage depth;
  /// 1 / dot(r, n) of the compared pixels, < 0. Here r is the pixel's PinholeCamera::ray(), and n
  /// the unit normal of the face.
  GrayImage inverse_facing;
  GrayImage intensity;  ///< copy of the photograph in `box` if the photograph is packed; else empty
  /// Bounding box of the compared pixels; inside `box`.
  PixelBox compared;
};

/// Visible surfaces of all views. For views with packed images (packable_image.h), only depths are
/// stored, in about a byte per pixel of the box. All other values are recomputed on demand. Faces
/// observed from behind are ignored and occlude nothing.
class SeenViews {
 public:
  /// Keeps references to `mesh` and `views`. Faces are not compared if the cosine between ray and
  /// normal is below `least_cosine`, >= 0. Parallel over views; the result does not depend on the
  /// number of threads.
  SeenViews(const Mesh& mesh, std::span<const View> views, double least_cosine);

  /// Returns the depths of all pixels that show front faces; 0 at other pixels.
  const VisibleDepths& depths(std::size_t view) const { return depths_[view]; }
  /// Returns the visible surface of a view. If it is not stored, computes it and stores it in
  /// `room`, in 28 bytes per pixel of the box. Thread-safe.
  const VisibleSurface& surface(std::size_t view, VisibleSurface& room) const;

 private:
  void see(std::size_t view, VisibleSurface& seen) const;

  const Mesh& mesh_;
  std::span<const View> views_;
  double least_cosine_;
  std::vector<Eigen::Vector3f> normals_;
  std::vector<VisibleDepths> depths_;
  std::vector<VisibleSurface> surfaces_;
};

}  // namespace transformesh
