/// Bytes as text. Reference: RFC 4648, with padding.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace transformesh {

std::string base64(std::string_view bytes);

/// Returns the bytes of a text in which blanks and line ends mean nothing, and which may consist of
/// several texts that end in padding each. Nothing if the text has other characters than base64.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace transformesh
