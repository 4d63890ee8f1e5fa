/// The surface as observed by one view, with all values per pixel that comparisons need.
#pragma once

#include "raster/rasterize.h"
#include "views/cameras/view.h"
#include "views/photo/visible_depths.h"

namespace transformesh {

/// Images cover `box`, the part of the view that shows the surface. Depths and facings are 0 at
/// pixels that are not compared.
struct VisibleSurface {
  PixelBox box;
  FaceBuffer faces;
  /// Depth of the compared pixels. These are the pixels that show the front of a face, unless the
  /// angle is too grazing (`least_cosine`).
  GrayImage depth;
  /// 1 / (r N) of the compared pixels, < 0. r is the pixel's PinholeCamera::ray, N the unit normal
  /// of the face.
  GrayImage inverse_facing;
  GrayImage intensity;  ///< part of the photograph, if that is packed; else empty
  /// Bounding box of the compared pixels; inside `box`.
  PixelBox compared;
};

/// Visible surfaces of all views. For packed views (PackableImage) only depths are stored, about a
/// byte per pixel of the box; all other values are recomputed on demand. Faces observed from behind
/// are ignored and occlude nothing.
class SeenViews {
 public:
  /// Keeps references to `mesh` and `views`. Faces are not compared if the cosine between ray and
  /// normal is below `least_cosine`, >= 0. Parallel over views; the result does not depend on the
  /// number of threads.
  SeenViews(const Mesh& mesh, std::span<const View> views, double least_cosine);

  /// Returns depths of all front faces; 0 at pixels without a face.
  const VisibleDepths& depths(std::size_t view) const { return depths_[view]; }
  /// Returns the visible surface of a view. If it is not stored, computes it into `room`, 28 bytes
  /// per pixel of the box. Thread-safe.
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
