/// The surface as one view sees it, with what a comparison of photographs needs per pixel.
#pragma once

#include "raster/rasterize.h"
#include "views/cameras/view.h"
#include "views/photo/visible_depths.h"

namespace transformesh {

/// Images are of a box of the view, beyond which nothing is seen, and 0 where there is nothing.
struct VisibleSurface {
  PixelBox box;
  FaceBuffer faces;
  /// Depth of the pixels that are compared, which see the outside of a face, and not too flatly
  /// along it.
  GrayImage depth;
  /// 1 / (r N) of these, r the pixel's PinholeCamera::ray and N the unit normal of the face: < 0.
  GrayImage inverse_facing;
  GrayImage intensity;  ///< of the photograph, where that is packed; else it is empty
  /// That of the compared pixels, within the box above.
  PixelBox compared;
};

/// What all views see. Of views that are packed (PackableImage) only depths are held, a byte or so
/// a pixel of the box, and all else is found when it is asked for. Backs of faces hide nothing.
class SeenViews {
 public:
  /// Keeps references to both. `least_cosine` is that of the angle between ray and normal below
  /// which a face is seen too flatly; >= 0. In parallel over views; the same for any number of
  /// threads.
  SeenViews(const Mesh& mesh, std::span<const View> views, double least_cosine);

  /// Of any face; 0 where there is none.
  const VisibleDepths& depths(std::size_t view) const { return depths_[view]; }
  /// In `room`, 28 bytes a pixel of the box, where it is not held. Safe to call from several
  /// threads.
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
