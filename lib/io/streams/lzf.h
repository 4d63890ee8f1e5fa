/// LZF, by which PCD files are compressed (M. A. Lehmann, LibLZF 3.6): a byte below 32 is followed
/// by so many bytes and one more as they are; any other repeats bytes that came before.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace transformesh {

/// Returns the expanded bytes; nothing if they are not exactly `size`, or the data is damaged.
std::optional<std::string> expand_lzf(std::string_view data, std::size_t size);

}  // namespace transformesh
