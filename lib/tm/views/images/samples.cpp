#include "tm/views/images/samples.h"

#include "tm/support/counted.h"

namespace transformesh {

void check_size(const Source& source, std::uint64_t width, std::uint64_t height,
                std::uint64_t samples_per_byte) {
  constexpr std::uint64_t largest = 1 << 30;
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) source.fail("the image has no pixel: " + size);
  if (width > largest || height > largest || width * height > largest) {
    source.fail("the image is too large: " + size);
  }
  if (width * height / samples_per_byte > source.bytes.size()) {
    source.fail("the image cannot have " + size + " in " + counted(source.bytes.size(), "byte"));
  }
}

}  // namespace transformesh
