#include "tm/views/images/image_file.h"

#include <algorithm>
#include <array>

#include "tm/views/images/samples.h"

namespace transformesh {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view png_start = "\x89PNG\r\n\x1a\n"sv;

bool is_pnm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && std::string_view("2356").find(bytes[1]) < 4 &&
         std::string_view(" \t\r\n#").find(bytes[2]) != std::string_view::npos;
}

Samples decode(std::string_view bytes, const std::string& name) {
  const Source source{bytes, name};
  if (bytes.empty()) source.fail("the file is empty: not a single byte of an image");
  if (bytes.starts_with(png_start)) return decode_png(source);
  if (is_pnm(bytes)) return decode_pnm(source);
  if (!is_image(bytes)) {
    source.fail("not an image of a known format, starting with " + quoted(bytes.substr(0, 16)));
  }
  return decode_other(source);
}

// The image of value(pixel's samples).
template <class Sample, class Value>
GrayImage image_of(const Samples& samples, const Sample* pixel, const Value& value) {
  GrayImage image(samples.width, samples.height);
  for (float& level : image.pixels) {
    level = value(pixel);
    pixel += samples.channels;
  }
  return image;
}

template <class Value>
GrayImage image_of(const Samples& samples, const Value& value) {
  return samples.is_deep() ? image_of(samples, samples.deep.data(), value)
                           : image_of(samples, samples.shallow.data(), value);
}

}  // namespace

bool is_image(std::string_view bytes) {
  if (is_pnm(bytes)) return true;
  constexpr std::array<std::string_view, 9> starts{png_start,
                                                   "\xff\xd8\xff"sv,
                                                   "II*\0"sv,
                                                   "MM\0*"sv,
                                                   "BM"sv,
                                                   "\x76\x2f\x31\x01"sv,
                                                   "#?RADIANCE"sv,
                                                   "\0\0\0\x0cjP  "sv,
                                                   "\xff\x4f\xff\x51"sv};
  const bool is_webp = bytes.starts_with("RIFF"sv) && bytes.substr(0, 12).ends_with("WEBP"sv);
  return is_webp || std::any_of(starts.begin(), starts.end(),
                                [&](std::string_view start) { return bytes.starts_with(start); });
}

GrayImage decode_photograph(std::string_view bytes, const std::string& name) {
  const Samples samples = decode(bytes, name);
  const double scale = 255 / samples.maximum;
  if (samples.channels == 1) {
    return image_of(samples,
                    [&](const auto* pixel) { return static_cast<float>(scale * pixel[0]); });
  }
  return image_of(samples, [&](const auto* pixel) {
    return static_cast<float>(scale * (0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2]));
  });
}

GrayImage decode_silhouette(std::string_view bytes, const std::string& name) {
  const Samples samples = decode(bytes, name);
  return image_of(samples, [&](const auto* pixel) {
    const bool is_inside =
        std::any_of(pixel, pixel + samples.channels, [](auto value) { return value != 0; });
    return is_inside ? 255.0F : 0.0F;
  });
}

}  // namespace transformesh
