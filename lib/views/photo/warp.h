/// Reprojection: finds for each pixel of a reference view the intensity in another view at the same
/// point of the surface.
/// Reference: Pons, Keriven & Faugeras, IJCV 72, 2007.
#pragma once

#include "views/cameras/view.h"
#include "views/images/interpolation.h"
#include "views/photo/visible_surface.h"

namespace transformesh {

/// Values for the pixels of one row of the reference view, from the first to the last compared
/// column. All values are 0 at pixels whose point of the surface is not visible in the other view.
struct WarpedRow {
  float* is_seen = nullptr;    ///< 1 if the point is visible in the other view, else 0
  float* reference = nullptr;  ///< intensity of the reference image minus `middle_intensity`
  float* other = nullptr;      ///< intensity of the other image minus `middle_intensity`
  /// Derivative of `other` with respect to the depth of the point in the reference view.
  float* slope = nullptr;
};

/// Number that is subtracted from intensities, so that sums of their squares lose fewer digits.
inline constexpr float middle_intensity = 128;

/// Memory for unpacked images and depths, which several warps use one after the other.
struct WarpRoom {
  GrayImage image;
  VisibleDepths depths;
};

class Warp {
 public:
  /// A point is hidden if it is behind the surface that is visible in `other` by more than the
  /// fraction `depth_tolerance` of its depth. All arguments must outlive the warp. If images are
  /// packed, `room` takes 6 bytes per pixel of the part that shows the surface.
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
  PixelBox part_;       ///< rectangle of the other view whose pixels are in `other_`
  const GrayImage& other_;
  const VisibleDepths& depths_;
  /// Maps homogeneous pixels of the reference view to those of the other view, for points at
  /// infinity.
  Eigen::Matrix3d turn_;
  Vec3 shift_;  ///< center of the reference camera in homogeneous pixels of the other view
  /// A point is hidden if its depth times this factor is larger than the depth of the visible
  /// surface.
  double nearer_;
};

}  // namespace transformesh
