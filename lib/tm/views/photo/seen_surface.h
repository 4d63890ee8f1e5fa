/// The surface as one view sees it, with what a comparison of photographs needs per pixel.
#pragma once

#include "tm/picture/rasterize.h"
#include "tm/views/cameras/view.h"

namespace transformesh {

/// Images are of the view's size, 0 where there is nothing.
struct SeenSurface {
  FaceBuffer faces;
  /// Depth of the pixels that are compared, which see the outside of a face, and not too flatly
  /// along it.
  GrayImage depth;
  /// 1 / (r N) of these, r the pixel's PinholeCamera::ray and N the unit normal of the face: < 0.
  GrayImage inverse_facing;
  /// The box of the compared pixels; the ends are excluded.
  int first_column = 0, end_column = 0;
  int first_row = 0, end_row = 0;
};

/// What all views see. Of views that are packed (HeldImage) only depths are held, 2 bytes a pixel,
/// and all else is found when it is asked for. Backs of faces hide nothing.
class SeenViews {
 public:
  /// Keeps references to both. `least_cosine` is that of the angle between ray and normal below
  /// which a face is seen too flatly; >= 0. In parallel over views; the same for any number of
  /// threads.
  SeenViews(const Mesh& mesh, std::span<const View> views, double least_cosine);

  /// Of any face; 0 where there is none.
  const HeldImage& depths(std::size_t view) const { return depths_[view]; }
  /// In `room`, 24 bytes a pixel, where it is not held. Safe to call from several threads.
  const SeenSurface& surface(std::size_t view, SeenSurface& room) const;

 private:
  SeenSurface see(std::size_t view) const;

  const Mesh& mesh_;
  std::span<const View> views_;
  double least_cosine_;
  std::vector<Eigen::Vector3f> normals_;
  std::vector<HeldImage> depths_;
  std::vector<SeenSurface> surfaces_;
};

}  // namespace transformesh
