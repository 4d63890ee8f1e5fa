/// Interprets the intensities of mask files.
#pragma once

#include "transformesh/image.h"

namespace transformesh {

enum class MaskRule {
  not_black,            ///< inside: pixels that are not black; for masks of few intensities
  alpha,                ///< inside: pixels that are at least half opaque; if transparency varies
  between_intensities,  ///< inside: pixels above the mean of the least and the largest intensity
};

struct Mask {
  GrayImage silhouette;  ///< 255 inside, else 0
  MaskRule rule = MaskRule::not_black;
};

/// Interprets a mask. `intensities` are the maxima of each pixel's channels, 0 to 255. `alpha` has
/// the same size or is empty.
///
/// The rule `between_intensities` applies if nearly all pixels that are not dark are bright, and
/// black is not exactly black. Black is inexact if no pixel has intensity 0, or if there are
/// several dark intensities besides 0, as noise and JPEG artifacts produce. Neither is true of
/// labels, and of photographs that are cut out in front of black.
Mask mask_of(GrayImage intensities, const GrayImage& alpha);

}  // namespace transformesh
