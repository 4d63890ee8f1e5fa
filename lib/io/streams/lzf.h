/// LZF, the compression of PCD files (M. A. Lehmann, LibLZF 3.6). A control byte n < 32 is followed
/// by n + 1 literal bytes; any other control byte repeats earlier output.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace transformesh {

/// Returns the decompressed bytes. Returns nothing if their number is not `size` or the data is
/// damaged.
std::optional<std::string> expand_lzf(std::string_view data, std::size_t size);

}  // namespace transformesh
