/// Bytes for a page made smaller, and text for HTML. Deterministic for a version of zlib.
#pragma once

#include <string>
#include <string_view>

namespace transformesh {

/// RFC 1950 (zlib), which browsers call `deflate`.
std::string deflated(std::string_view bytes);

/// As text of HTML or the value of an attribute.
std::string html_escaped(std::string_view text);

}  // namespace transformesh
