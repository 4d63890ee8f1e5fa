#include "io/streams/lzf.h"

#include <algorithm>

namespace transformesh {

std::optional<std::string> expand_lzf(std::string_view data, std::size_t size) {
  std::string bytes;
  // Largest number of output bytes for one byte of input: three bytes encode at most 264 bytes.
  constexpr std::size_t largest_ratio = 88;
  bytes.reserve(std::min(size, largest_ratio * data.size()));
  std::size_t at = 0;
  const auto next = [&]() -> std::size_t { return static_cast<unsigned char>(data[at++]); };
  while (at < data.size()) {
    const std::size_t control = next();
    if (control < 32) {
      const std::size_t count = control + 1;
      if (count > data.size() - at || count > size - bytes.size()) return std::nullopt;
      bytes.append(data.substr(at, count));
      at += count;
      continue;
    }
    std::size_t count = control / 32;
    if (at + (count == 7 ? 2 : 1) > data.size()) return std::nullopt;
    if (count == 7) count += next();
    const std::size_t back = control % 32 * 256 + next() + 1;
    count += 2;
    if (back > bytes.size() || count > size - bytes.size()) return std::nullopt;
    // Source and destination may overlap, so the bytes are copied one by one.
    for (std::size_t i = 0; i < count; ++i) bytes += bytes[bytes.size() - back];
  }
  return bytes.size() == size ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace transformesh
