/// Bytes as text. Reference: RFC 4648, with padding.
#pragma once

#include <string>
#include <string_view>

namespace transformesh {

std::string base64(std::string_view bytes);

}  // namespace transformesh
