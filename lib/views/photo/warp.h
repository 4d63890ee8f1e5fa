/// Reprojection: finds for each pixel of a reference view the intensity in another view at the same
/// point of the surface.
/// Reference: Pons, Keriven & Faugeras, IJCV 72, 2007.
#pragma once

#include "views/cameras/view.h"
#include "views/images/interpolation.h"
#include "views/photo/visible_surface.h"

namespace transformesh {

/// One row of a warp, from the first to the last compared column of the reference view. All values
/// are 0 at points that are not visible in the other view.
struct WarpedRow {
  float* is_seen = nullptr;    ///< 1 or 0
  float* reference = nullptr;  ///< intensity of the reference image minus `middle_intensity`
  float* other = nullptr;      ///< intensity of the other image minus `middle_intensity`
  /// Derivative of `other` with respect to the depth of the point in the reference view.
  float* slope = nullptr;
};

/// Subtracted from intensities, so that sums of their squares lose fewer digits.
inline constexpr float middle_intensity = 128;

/// Memory for unpacked images and depths, to be reused from warp to warp.
struct WarpRoom {
  GrayImage image;
  VisibleDepths depths;
};

class Warp {
 public:
  /// A point is hidden if it is behind the visible surface of `other` by more than the fraction
  /// `depth_tolerance` of its depth. All arguments must outlive the warp. `room` takes 6 bytes per
  /// pixel of the visible part of a packed image.
  Warp(const View& reference, const VisibleSurface& seen_by_reference, const View& other,
       const VisibleDepths& depths_of_other, double depth_tolerance, WarpRoom& room);
  Warp(const Warp&) = delete;
  Warp& operator=(const Warp&) = delete;
  ~Warp() = default;

  void row(int y, Interpolation interpolation, const WarpedRow& out) const;

 private:
  template <Interpolation interpolation>
  void row(int y, const WarpedRow& out) const;

  const PackableImage& reference_;
  const VisibleSurface& seen_;
  int width_, height_;  ///< size of the other view
  PixelBox part_;       ///< part of the other view that is in `other_`
  const GrayImage& other_;
  const VisibleDepths& depths_;
  /// Maps homogeneous pixels of the reference view to homogeneous pixels of the other view, for
  /// points at infinity.
  Eigen::Matrix3d turn_;
  Vec3 shift_;     ///< center of the reference camera in homogeneous pixels of the other view
  double nearer_;  ///< a point is hidden if its depth times this is beyond the visible depth
};

}  // namespace transformesh
