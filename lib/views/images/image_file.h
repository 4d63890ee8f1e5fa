/// Photographs and silhouettes from files, JPEG, PNG, TIFF and PNM (P2, P3, P5, P6), and as
/// pictures that can be written (raster/png.h). The format is detected by the first bytes, not by
/// the name.
///
/// Pixels stay where the file has them: a camera is calibrated for those, so that a wish to show
/// the photograph rotated (Exif) is ignored. Transparency counts in masks only.
#pragma once

#include <string>
#include <string_view>

#include "transformesh/image.h"
#include "views/images/mask.h"

namespace transformesh {

/// Whether the bytes begin like an image file, be it of a format that is not read.
bool is_image(std::string_view bytes);

/// Decodes a picture in color, 8 bits a channel, opaque. Throws as decode_photograph() does.
Image decode_picture(std::string_view bytes, const std::string& name);

/// Width and height as its header has them, without a pixel. Throws as decode_photograph does, but
/// for errors that only the pixels show.
GrayImage decode_size(std::string_view bytes, const std::string& name);

/// Inside is what the intensities or the transparency show (mask.h). Throws as decode_photograph
/// does.
Mask decode_mask(std::string_view bytes, const std::string& name);

/// The same without the rule that was applied.
GrayImage decode_silhouette(std::string_view bytes, const std::string& name);

/// Intensities from 0 to 255, rounded to whole ones and cut off beyond; opaque.
Image picture_of(const GrayImage& image);

}  // namespace transformesh
