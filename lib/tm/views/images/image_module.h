/// What the module that decodes images by OpenCV offers to whom loads it.
#pragma once

#include <string>
#include <string_view>

#include "tm/views/images/samples.h"

namespace transformesh {

/// False where the bytes are no complete image, with the reason where there is one. Throws nothing.
using DecodeImage = bool(std::string_view bytes, Samples& samples, std::string& problem) noexcept;
inline constexpr const char* decode_image_name = "tm_decode_image";

}  // namespace transformesh
