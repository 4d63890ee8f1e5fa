/// One view seen through another: for a pixel of the reference view, what the other view shows at
/// the same point of the surface (the reprojection of Pons, Keriven & Faugeras, IJCV 72, 2007).
#pragma once

#include "views/images/interpolation.h"
#include "views/photo/visible_surface.h"

namespace transformesh {

/// One row, from the first to the last compared column of the reference view. Where the other view
/// does not show the point, all are 0.
struct WarpedRow {
  float* is_seen = nullptr;    ///< 1 or 0
  float* reference = nullptr;  ///< intensity of the reference image, less `middle_intensity`
  float* other = nullptr;      ///< intensity of the other image, less `middle_intensity`
  float* slope = nullptr;      ///< derivative of `other` by the depth of the point
};

/// Intensities are less this one, so that sums of their squares keep their digits.
inline constexpr float middle_intensity = 128;

/// For images that are packed.
struct WarpRoom {
  GrayImage image;
  VisibleDepths depths;
};

class Warp {
 public:
  /// A point is hidden where it is farther than the surface by more than `depth_tolerance` of its
  /// depth. What is passed must outlive the warp; `room` takes 6 bytes a pixel of
  /// what is seen of an image that is packed.
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
  int width_, height_;  ///< of the other view
  PixelBox part_;       ///< of it, that is in `other_`
  const GrayImage& other_;
  const VisibleDepths& depths_;
  Eigen::Matrix3d turn_;  ///< from pixels of the reference to rays in pixels of the other
  Vec3 shift_;            ///< the reference's center in pixels of the other
  double nearer_;
};

}  // namespace transformesh
