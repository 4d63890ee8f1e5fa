/// Signed distances from the contour of a silhouette, at pixels and between them.
///
/// Pixels of a silhouette are above 127.5 inside and below outside. The contour is the curve where
/// the bilinearly interpolated intensity is 127.5. Masks of two intensities thus have the contour
/// half-way between pixels; masks with antialiased edges have a more precise one. The border of an
/// image is not part of the contour, even if the object extends beyond the image. The contour
/// outside of the image is not known.
#pragma once

#include <limits>

#include "views/images/packable_image.h"

namespace transformesh {

inline constexpr float contour_intensity = 127.5F;  ///< half-way between 0 and 255

/// Returns the distance of every pixel from the contour, in pixels, positive outside. Without a
/// contour all distances are infinite. Distances are cut off at `limit`; `limit` does not change
/// distances well below it.
/// Reference: Danielsson, "Euclidean distance mapping", CGIP 14 (1980). Unlike there, the nearest
/// contour segment is propagated, not the nearest pixel. Distances may be too large by a few
/// hundredths of a pixel, because only neighbors are considered. O(pixels), two sweeps;
/// deterministic.
GrayImage signed_distance(const GrayImage& silhouette,
                          float limit = std::numeric_limits<float>::infinity());

/// Result of distance_at() outside of the image.
inline constexpr float unknown_distance = std::numeric_limits<float>::quiet_NaN();

/// Returns the bilinearly interpolated distance at (x, y). Returns unknown_distance for points that
/// are more than half a pixel beyond the outermost pixel centers.
float distance_at(const GrayImage& distances, double x, double y);
float distance_at(const PackableImage& distances, double x, double y);

}  // namespace transformesh
