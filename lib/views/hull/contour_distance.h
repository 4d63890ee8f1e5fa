/// Computes signed distances from the contour of a silhouette, at pixel centers and between them.
///
/// Pixels of a silhouette are above 127.5 inside and below outside. The contour is the curve where
/// the bilinearly interpolated intensity is 127.5. Masks that only have the intensities 0 and 255
/// thus have their contour half-way between pixels. Masks with antialiased edges have a more
/// precise contour. The border of an image is not part of the contour, even if the object extends
/// beyond the image. The contour of the object outside of the image is not known.
#pragma once

#include <limits>

#include "views/images/packable_image.h"

namespace transformesh {

inline constexpr float contour_intensity = 127.5F;  ///< half-way between 0 and 255

/// True if a pixel of this intensity is inside the contour.
inline bool is_inside_contour(float intensity) { return intensity > contour_intensity; }

/// Returns the distance of every pixel from the contour, in pixels, positive outside. Without a
/// contour all distances are infinite. Distances above `limit` are replaced by `limit`. Smaller
/// distances are not affected, except for those within a few pixels of `limit`.
/// Reference: Danielsson, "Euclidean distance mapping", CGIP 14 (1980). Unlike in this reference,
/// the nearest contour segment is propagated from pixel to pixel, not the nearest pixel. Distances
/// may be too large by a few hundredths of a pixel, because a pixel only considers the nearest
/// segments of its neighbors. O(pixels), in two passes over the image; deterministic.
GrayImage signed_distance(const GrayImage& silhouette,
                          float limit = std::numeric_limits<float>::infinity());

/// Result of distance_at() at points outside of the image.
inline constexpr float unknown_distance = std::numeric_limits<float>::quiet_NaN();

/// Returns the bilinearly interpolated distance at (x, y). Returns `unknown_distance` for points
/// more than half a pixel outside of the rectangle of all pixel centers.
float distance_at(const GrayImage& distances, double x, double y);
float distance_at(const PackableImage& distances, double x, double y);

}  // namespace transformesh
