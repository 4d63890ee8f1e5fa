#include "views/images/decoders.h"

#include <algorithm>
#include <filesystem>

#include "support/counted.h"

namespace transformesh {
namespace {

template <class Sample, class Value>
void append(const Sample* pixel, const SampleLayout& layout, const Value& value,
            std::vector<float>& intensities) {
  const std::size_t start = intensities.size();
  intensities.resize(start + static_cast<std::size_t>(layout.width));
  for (auto intensity = intensities.begin() + static_cast<std::ptrdiff_t>(start);
       intensity != intensities.end(); ++intensity, pixel += layout.stride)
    *intensity = value(pixel);
}

}  // namespace

bool IntensityRows::start(const SampleLayout& layout) {
  /// Number of pixels for which memory is allocated at first; memory for larger images grows while
  /// rows are decoded.
  constexpr std::size_t most_at_once = 1 << 24;
  layout_ = layout;
  image_.width = layout.width;
  image_.height = layout.height;
  if (kind_ == Kind::size) return false;
  if (kind_ == Kind::picture) {
    picture_.width = layout.width, picture_.height = layout.height;
    return true;
  }
  if (layout.has_alpha) alpha_.width = layout.width, alpha_.height = layout.height;
  image_.pixels.reserve(std::min(most_at_once, static_cast<std::size_t>(layout.width) *
                                                   static_cast<std::size_t>(layout.height)));
  return true;
}

template <class Sample>
void IntensityRows::add_picture_row(const Sample* row) {
  const double scale = 255 / layout_.maximum;
  const auto intensity = [&](const Sample* pixel, int channel) {
    return static_cast<std::uint8_t>(scale * pixel[std::min(channel, layout_.channels - 1)] + 0.5);
  };
  for (int x = 0; x < layout_.width; ++x, row += layout_.stride)
    picture_.pixels.push_back({intensity(row, 0), intensity(row, 1), intensity(row, 2), 255});
}

template <class Sample>
void IntensityRows::add_row(const Sample* row) {
  if (kind_ == Kind::picture) return add_picture_row(row);
  const double scale = 255 / layout_.maximum;
  const auto gray = [&](const Sample* pixel) { return static_cast<float>(scale * pixel[0]); };
  const auto luma = [&](const Sample* pixel) {
    return static_cast<float>(scale * (0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2]));
  };
  const auto largest = [&](const Sample* pixel) {
    return static_cast<float>(scale * *std::max_element(pixel, pixel + layout_.channels));
  };
  const auto opacity = [&](const Sample* pixel) {
    return static_cast<float>(scale * pixel[layout_.channels]);
  };
  if (kind_ == Kind::silhouette) {
    if (layout_.has_alpha) append(row, layout_, opacity, alpha_.pixels);
    return append(row, layout_, largest, image_.pixels);
  }
  layout_.channels == 1 ? append(row, layout_, gray, image_.pixels)
                        : append(row, layout_, luma, image_.pixels);
}

template void IntensityRows::add_row(const std::uint8_t* row);
template void IntensityRows::add_row(const std::uint16_t* row);

void check_size(const Source& source, std::uint64_t width, std::uint64_t height,
                std::uint64_t pixels_per_byte) {
  // Largest number of pixels; indices of pixels then fit into 32 bits.
  constexpr std::uint64_t largest = 1 << 29;
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width == 0 || height == 0) source.fail("the image has no pixel: " + size);
  if (width > largest || height > largest || width * height > largest) {
    source.fail("the image is too large: " + size);
  }
  if (width * height / pixels_per_byte > source.bytes.size()) {
    source.fail("an image of " + size + " cannot be stored in " +
                counted(source.bytes.size(), "byte"));
  }
}

void refuse_format(const Source& source, const std::string& format) {
  const std::string png = std::filesystem::path(source.name).replace_extension("png").string();
  source.fail("the format is " + format +
              "; only JPEG, PNG, TIFF and PNM of 8 or 16 bits are read: convert it first, for "
              "example with: magick " +
              source.name + " " + png);
}

}  // namespace transformesh
