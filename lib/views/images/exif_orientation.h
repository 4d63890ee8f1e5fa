/// How an image file asks viewers to turn its pixels. References: CIPA DC-008, "Exchangeable image
/// file format for digital still cameras", tag Orientation; Adobe, "TIFF", revision 6.0, section 2.
#pragma once

#include <string_view>

namespace transformesh {

/// Returns the orientation of a JPEG or TIFF file, 1 to 8; 1 if it states none. Pixels are stored
/// as they are shown if it is 1. Width and height are exchanged if it is 5 or more.
int exif_orientation(std::string_view bytes);

}  // namespace transformesh
