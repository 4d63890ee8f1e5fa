/// Silhouettes: where an image shows the object, and how far a place is from its contour.
///
/// In memory a silhouette is above 127.5 inside and below outside; its contour is where the levels,
/// interpolated between pixel centres, cross 127.5. Masks of two levels thus have it half-way
/// between pixels, masks with soft edges know it better. Beyond the outermost pixels nothing is
/// known: there is no contour along the border of an image, even where the object leaves it.
#pragma once

#include <limits>
#include <optional>
#include <span>

#include "tm/views/images/gray_image.h"

namespace transformesh {

struct ThresholdOptions {
  /// (0, 255): the object is brighter than that. Default: the dividing_level of the image. Of
  /// several views agreed_level.h knows more.
  std::optional<double> level = std::nullopt;
  double blur = 1.5;    ///< >= 0: deviation in pixels of the Gaussian that is applied before
  double close = 0.01;  ///< [0, 1]: per larger side of the image; dark marks on the object, and
                        ///< gaps in it, that are less than twice as wide become part of it
};

/// The level that best divides the pixels of all images into dark and bright ones (Otsu, "A
/// threshold selection method from gray-level histograms", IEEE Trans. SMC 9, 1979), in the middle
/// of the levels that no pixel has. From 0.5 to 254.5.
double dividing_level(std::span<const GrayImage> images);

/// The silhouette of a bright object before a dark background. Its contour is where the blurred
/// image crosses the level, but for what is closed (dilated and eroded, with discs). Throws
/// UsageError for options out of range. O(pixels).
GrayImage threshold_silhouette(const GrayImage& image, const ThresholdOptions& options = {});

/// 255 inside and 0 outside: as masks in files are.
GrayImage two_levels(const GrayImage& silhouette);

/// Share of the pixels that are inside.
double inside_share(const GrayImage& silhouette);

/// Intersection over union of the insides of two silhouettes of one size; 1 where both are empty.
/// Throws UsageError for other sizes.
double silhouette_agreement(const GrayImage& first, const GrayImage& second);

/// The signed distance of every pixel to the contour, in pixels, positive outside. Infinite, with
/// that sign, where there is no contour. May be too large by a few hundredths of a pixel.
/// O(pixels), two sweeps; deterministic. Reference: Danielsson, "Euclidean distance mapping", CGIP
/// 14 (1980).
GrayImage signed_distance(const GrayImage& silhouette);

/// What `distance_at` says of places outside the image.
inline constexpr float unknown_distance = std::numeric_limits<float>::quiet_NaN();

/// The distance at a place between pixels, bilinear; unknown_distance more than half a pixel beyond
/// the outermost pixel centres.
float distance_at(const GrayImage& distances, double x, double y);

}  // namespace transformesh
