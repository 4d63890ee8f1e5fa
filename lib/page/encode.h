/// Bytes for a page: smaller, and as text. Deterministic for a version of zlib.
#pragma once

#include <string>
#include <string_view>

namespace transformesh {

/// RFC 1950 (zlib), which browsers call `deflate`.
std::string deflated(std::string_view bytes);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// As text of HTML or the value of an attribute.
std::string html_escaped(std::string_view text);

}  // namespace transformesh
