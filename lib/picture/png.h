/// PNG in memory, by libpng.
#pragma once

#include <string>

#include "picture/image.h"

namespace transformesh {

/// The bytes of a PNG file: RGB where every pixel is opaque, else RGBA; 8 bits, sRGB. No time stamp
/// or other chunk that changes between runs. Throws UsageError for an image without pixels and
/// GoalError with libpng's words where it fails.
std::string write_png(const Image& image);

}  // namespace transformesh
