/// Grey images as pictures that can be written (picture/png.h).
#pragma once

#include "tm/picture/image.h"
#include "tm/views/images/gray_image.h"

namespace transformesh {

/// Levels from 0 to 255, rounded to whole ones and cut off beyond; opaque.
Image picture_of(const GrayImage& image);

}  // namespace transformesh
