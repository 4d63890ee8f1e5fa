/// Converts bytes to base64 with padding, and back. Reference: RFC 4648.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace transformesh {

std::string base64(std::string_view bytes);

/// Decodes a text, which may be a concatenation of several padded texts. Ignores blanks and line
/// ends. Returns nothing if the text has other characters than base64.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace transformesh
