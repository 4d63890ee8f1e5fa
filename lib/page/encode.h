/// Compresses bytes for a page, and escapes text for HTML. Deterministic for a given version of
/// zlib.
#pragma once

#include <string>
#include <string_view>

namespace transformesh {

/// Compresses to the zlib format (RFC 1950), which browsers call `deflate`.
std::string deflated(std::string_view bytes);

/// Escapes text for HTML elements and attribute values.
std::string html_escaped(std::string_view text);

}  // namespace transformesh
