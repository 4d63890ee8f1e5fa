/// How far each pixel of a silhouette, and each place between pixels, is from its contour.
///
/// In memory a silhouette is above 127.5 inside and below outside; its contour is where the
/// intensities, interpolated between pixel centers, cross 127.5. Masks of two intensities thus have
/// it half-way between pixels, masks with soft edges know it better. Beyond the outermost pixels
/// nothing is known: there is no contour along the border of an image, even where the object leaves
/// it.
#pragma once

#include <limits>

#include "views/images/packable_image.h"

namespace transformesh {

inline constexpr float contour_intensity = 127.5F;

/// The signed distance of every pixel to the contour, in pixels, positive outside. Infinite, with
/// that sign, where there is no contour. May be too large by a few hundredths of a pixel. No
/// distance is above `limit`; those well below it are not changed by it.
/// O(pixels), two sweeps; deterministic. Reference: Danielsson, "Euclidean distance mapping",
/// CGIP 14 (1980).
GrayImage signed_distance(const GrayImage& silhouette,
                          float limit = std::numeric_limits<float>::infinity());

/// What `distance_at` says of places outside the image.
inline constexpr float unknown_distance = std::numeric_limits<float>::quiet_NaN();

/// The distance at a place between pixels, bilinear; unknown_distance more than half a pixel beyond
/// the outermost pixel centers.
float distance_at(const GrayImage& distances, double x, double y);
float distance_at(const PackableImage& distances, double x, double y);

}  // namespace transformesh
