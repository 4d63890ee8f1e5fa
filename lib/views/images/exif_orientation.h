/// How an image file asks viewers to turn its pixels. References: CIPA DC-008, "Exchangeable image
/// file format for digital still cameras", tag Orientation; Adobe, "TIFF", revision 6.0, section 2.
#pragma once

#include <string_view>

namespace transformesh {

/// Returns the orientation of a JPEG or TIFF file: 1 if pixels are stored as they are shown, 5 to 8
/// if width and height are exchanged, else 2 to 4. Returns 1 if the file states none.
int exif_orientation(std::string_view bytes);

}  // namespace transformesh
