#include "views/images/exif_orientation.h"

#include <cstdint>
#include <optional>

namespace transformesh {
namespace {

constexpr std::uint32_t orientation_tag = 0x112;  ///< number of the tag in Exif

std::uint32_t unsigned_byte_at(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

/// The directory of a TIFF file or of Exif data, whose first bytes state the byte order.
class TiffDirectory {
 public:
  explicit TiffDirectory(std::string_view bytes)
      : bytes_(bytes), is_little_(bytes.starts_with("II")) {}

  int orientation() const {
    const auto start = number(4, 4);
    const auto count = start ? number(*start, 2) : std::nullopt;
    if (!count) return 1;
    for (std::size_t i = 0; i < *count; ++i) {
      const std::size_t entry = *start + 2 + 12 * i;
      if (number(entry, 2) != orientation_tag) continue;
      const auto value = number(entry + 8, 2);
      return value && *value >= 1 && *value <= 8 ? static_cast<int>(*value) : 1;
    }
    return 1;
  }

 private:
  std::optional<std::uint32_t> number(std::size_t at, std::size_t size) const {
    if (at + size > bytes_.size()) return {};
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | unsigned_byte_at(bytes_, at + (is_little_ ? size - 1 - i : i));
    return value;
  }

  std::string_view bytes_;
  bool is_little_;
};

/// Returns the Exif data of a JPEG file, or "".
std::string_view exif_of_jpeg(std::string_view bytes) {
  constexpr std::string_view title("Exif\0\0", 6);
  constexpr std::uint32_t application_1 = 0xe1;  // marker of the segment with Exif data
  constexpr std::uint32_t start_of_scan = 0xda;  // marker after which no Exif segment follows
  std::size_t at = 2;
  while (at + 4 <= bytes.size() && unsigned_byte_at(bytes, at) == 0xff) {
    const std::uint32_t marker = unsigned_byte_at(bytes, at + 1);
    const std::size_t size = unsigned_byte_at(bytes, at + 2) << 8 | unsigned_byte_at(bytes, at + 3);
    if (marker == start_of_scan || size < 2) break;
    const std::string_view segment = bytes.substr(at + 4, size - 2);
    if (marker == application_1 && segment.starts_with(title)) return segment.substr(title.size());
    at += 2 + size;
  }
  return {};
}

}  // namespace

int exif_orientation(std::string_view bytes) {
  const bool is_jpeg = bytes.starts_with("\xff\xd8");
  const std::string_view tiff = is_jpeg ? exif_of_jpeg(bytes) : bytes;
  const bool is_tiff = tiff.starts_with("II*") || tiff.starts_with(std::string_view("MM\0*", 4));
  return is_tiff ? TiffDirectory(tiff).orientation() : 1;
}

}  // namespace transformesh
