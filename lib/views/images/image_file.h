/// Reads photographs and silhouettes from JPEG, PNG, TIFF and PNM (P2, P3, P5, P6), and converts
/// them to pictures for write_png() (image.h). The format is detected by the first bytes, not by
/// the name.
///
/// Exif orientation is ignored, because cameras are calibrated for pixels as stored in the file.
/// Transparency is used for masks only.
#pragma once

#include <string>
#include <string_view>

#include "transformesh/image.h"
#include "views/images/mask.h"

namespace transformesh {

/// True if the bytes begin like an image file of a known format, even if the format is not
/// supported.
bool is_image(std::string_view bytes);

/// Decodes a color picture: 8 bits per channel, opaque. Throws as decode_photograph() does.
Image decode_picture(std::string_view bytes, const std::string& name);

/// Decodes the header only. Returns an image with width and height, but without pixels. Throws as
/// decode_photograph() does, except for errors that only occur while decoding pixels.
GrayImage decode_size(std::string_view bytes, const std::string& name);

/// Decodes a mask by its intensities or its transparency (mask.h). Throws as decode_photograph()
/// does.
Mask decode_mask(std::string_view bytes, const std::string& name);

/// Converts to an opaque gray picture. Intensities are rounded and clamped to [0, 255].
Image picture_of(const GrayImage& image);

}  // namespace transformesh
