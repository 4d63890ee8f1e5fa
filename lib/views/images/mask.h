/// Decides which pixels of a mask file are inside the object.
#pragma once

#include "transformesh/image.h"

namespace transformesh {

enum class MaskRule {
  not_black,  ///< pixels that are not black are inside; the rule for masks of few intensities
  alpha,      ///< pixels that are at least half opaque are inside; the rule if transparency varies
  /// Pixels above the mean of the least and the largest intensity are inside; the rule for noisy
  /// black and white.
  between_intensities,
};

struct Mask {
  GrayImage silhouette;  ///< 255 inside, else 0
  MaskRule rule = MaskRule::not_black;
};

/// Returns the silhouette of a mask file. The intensity of a pixel is the maximum of its channels,
/// from 0 to 255. `alpha` is the opacity of each pixel, or empty.
///
/// The rule `between_intensities` applies if both of two conditions hold. First, intensities span
/// at least 64, and nearly all pixels that are not dark are bright. Second, black is inexact: no
/// pixel has intensity 0, or there are several dark intensities besides 0, as noise and JPEG
/// artifacts produce. Label images and photographs whose background was replaced by black do not
/// fulfill both.
Mask mask_of(GrayImage intensities, const GrayImage& alpha);

}  // namespace transformesh
