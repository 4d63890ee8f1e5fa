#include "views/images/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "views/images/decoders.h"

namespace transformesh {
namespace {

using namespace std::string_view_literals;

bool is_pnm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && std::string_view("2356").find(bytes[1]) < 4 &&
         std::string_view(" \t\r\n#").find(bytes[2]) != std::string_view::npos;
}

struct Format {
  std::string_view start;
  const char* name;
  /// Null if the format is not supported.
  void (*decode)(const Source& source, IntensityRows& rows) = nullptr;
};

constexpr std::array formats{Format{"\x89PNG\r\n\x1a\n"sv, "PNG", decode_png},
                             Format{"\xff\xd8\xff"sv, "JPEG", decode_jpeg},
                             Format{"II*\0"sv, "TIFF", decode_tiff},
                             Format{"MM\0*"sv, "TIFF", decode_tiff},
                             Format{"II+\0"sv, "TIFF", decode_tiff},
                             Format{"MM\0+"sv, "TIFF", decode_tiff},
                             Format{"BM"sv, "BMP"},
                             Format{"GIF8"sv, "GIF"},
                             Format{"\x76\x2f\x31\x01"sv, "OpenEXR"},
                             Format{"#?RADIANCE"sv, "Radiance"},
                             Format{"\0\0\0\x0cjP  "sv, "JPEG 2000"},
                             Format{"\xff\x4f\xff\x51"sv, "JPEG 2000"}};
constexpr Format pnm{"P", "PNM", decode_pnm};
constexpr Format webp{"RIFF", "WebP"};
constexpr Format heif{"", "HEIF"};

/// Returns the format that matches the first bytes of a file, or null if none does.
const Format* format_of(std::string_view bytes) {
  if (is_pnm(bytes)) return &pnm;
  if (bytes.starts_with(webp.start) && bytes.substr(0, 12).ends_with("WEBP")) return &webp;
  if (bytes.substr(0, 8).ends_with("ftyp")) return &heif;
  const auto* format = std::find_if(formats.begin(), formats.end(), [&](const Format& known) {
    return bytes.starts_with(known.start);
  });
  return format == formats.end() ? nullptr : format;
}

IntensityRows decode(std::string_view bytes, const std::string& name, IntensityRows::Kind kind) {
  const Source source{bytes, name};
  if (bytes.empty()) source.fail("the file is empty: it contains no image");
  const Format* format = format_of(bytes);
  if (format == nullptr) {
    source.fail("not an image of a known format, starting with " + in_quotes(bytes.substr(0, 16)));
  }
  if (format->decode == nullptr) refuse_format(source, format->name);
  IntensityRows rows(kind);
  format->decode(source, rows);
  return rows;
}

}  // namespace

bool is_image(std::string_view bytes) { return format_of(bytes) != nullptr; }

GrayImage decode_photograph(std::string_view bytes, const std::string& name) {
  return decode(bytes, name, IntensityRows::Kind::photograph).take();
}

Image decode_picture(std::string_view bytes, const std::string& name) {
  return decode(bytes, name, IntensityRows::Kind::picture).take_picture();
}

GrayImage decode_size(std::string_view bytes, const std::string& name) {
  return decode(bytes, name, IntensityRows::Kind::size).take();
}

Mask decode_mask(std::string_view bytes, const std::string& name) {
  IntensityRows rows = decode(bytes, name, IntensityRows::Kind::silhouette);
  return mask_of(rows.take(), rows.take_alpha());
}

Image picture_of(const GrayImage& image) {
  Image picture(image.width, image.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float intensity = std::clamp(std::round(image.pixels[i]), 0.0F, 255.0F);
    const auto byte = static_cast<std::uint8_t>(intensity);
    picture.pixels[i] = {byte, byte, byte, 255};
  }
  return picture;
}

}  // namespace transformesh
