/// Reads how an image file asks viewers to turn or mirror its pixels. References: CIPA DC-008,
/// "Exchangeable image file format for digital still cameras", tag Orientation; Adobe, "TIFF",
/// revision 6.0, section 2.
#pragma once

#include <string_view>

namespace transformesh {

/// Returns the orientation of a JPEG or TIFF file, from 1 to 8. Returns 1 if the file states none.
/// At orientation 1, pixels are stored as viewers show them. From 5 to 8, width and height are
/// exchanged.
int exif_orientation(std::string_view bytes);

}  // namespace transformesh
