/// Meaning of the intensities of a mask in a file.
#pragma once

#include "transformesh/image.h"

namespace transformesh {

enum class MaskRule {
  not_black,            ///< inside is what is not black, as of masks of few intensities
  alpha,                ///< what is at least half opaque: transparency varies, so it is the mask
  between_intensities,  ///< what is brighter than half-way from the darkest intensity to the
                        ///< brightest
};

struct Mask {
  GrayImage silhouette;  ///< 255 inside, else 0
  MaskRule rule = MaskRule::not_black;
};

/// Intensities are the largest of a pixel's channels, 0 to 255; `alpha` is of their size, or empty.
///
/// Half-way is the rule where nearly all of what is not dark is bright, and black is not quite
/// black: where there are several dark intensities beside 0, as noise and JPEG's ringing leave
/// them, or no pixel of intensity 0 at all. Labels, and photographs cut out before black, are not
/// like that.
Mask mask_of(GrayImage intensities, const GrayImage& alpha);

}  // namespace transformesh
