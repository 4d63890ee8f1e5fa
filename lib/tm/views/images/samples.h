/// The samples of an image file before they become grey levels, and who decodes them. Internal to
/// image_file.
#pragma once

#include <cstdint>
#include <vector>

#include "tm/io/source.h"

namespace transformesh {

struct Samples {
  int width = 0;
  int height = 0;
  int channels = 1;      ///< 1: grey; 3: red, green, blue
  double maximum = 255;  ///< the sample that is full intensity; the depth is 8 bits up to 255
  std::vector<std::uint8_t> shallow;  ///< samples of 8 bits
  std::vector<std::uint16_t> deep;    ///< samples of 16 bits

  bool is_deep() const { return maximum > 255; }
  /// Makes room for the samples.
  void allocate() {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                              static_cast<std::size_t>(channels);
    is_deep() ? deep.resize(count) : shallow.resize(count);
  }
};

/// By libpng: any colour type and depth; transparency is left out. Throws InputError.
Samples decode_png(const Source& source);
/// Portable bitmaps: P2, P3, P5 and P6. Throws InputError.
Samples decode_pnm(const Source& source);
/// By OpenCV, which is loaded when it is first needed. Throws InputError.
Samples decode_other(const Source& source);

/// Throws InputError unless width and height are at least 1 and their product fits an int, and the
/// bytes could hold so many samples: at most `samples_per_byte` in each.
void check_size(const Source& source, std::uint64_t width, std::uint64_t height,
                std::uint64_t samples_per_byte);

}  // namespace transformesh
