#include <png.h>

#include <algorithm>

#include "transformesh/errors.h"
#include "transformesh/image.h"

namespace transformesh {
namespace {

struct Output {
  std::string bytes;
  std::string failure;
};

void append(png_structp png, png_bytep data, png_size_t size) {
  auto* output = static_cast<Output*>(png_get_io_ptr(png));
  output->bytes.append(reinterpret_cast<const char*>(data), size);
}

void flush(png_structp) {}

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  static_cast<Output*>(png_get_error_ptr(png))->failure = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// Copies the first `channels` channels of each pixel of a row: RGB or RGBA.
void pack(const Pixel* pixels, int width, std::size_t channels, png_byte* bytes) {
  for (int x = 0; x < width; ++x) bytes = std::copy_n(pixels[x].begin(), channels, bytes);
}

/// libpng leaves this function by longjmp, so that it must not create objects with destructors.
bool encode(png_structp png, png_infop info, const Image& image, png_byte* packed,
            std::size_t channels) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const auto width = static_cast<png_uint_32>(image.width);
  const auto height = static_cast<png_uint_32>(image.height);
  png_set_IHDR(png, info, width, height, 8,
               channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, 6);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) {
    pack(image.row(y), image.width, channels, packed);
    png_write_row(png, packed);
  }
  png_write_end(png, info);
  return true;
}

}  // namespace

std::string write_png(const Image& image) {
  if (image.pixels.empty()) throw UsageError("a picture needs at least one pixel each way");
  const bool is_opaque = std::all_of(image.pixels.begin(), image.pixels.end(),
                                     [](const Pixel& pixel) { return pixel[3] == 255; });
  const std::size_t channels = is_opaque ? 3 : 4;
  std::vector<png_byte> row(static_cast<std::size_t>(image.width) * channels);

  Output output;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, fail, ignore_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info != nullptr) png_set_write_fn(png, &output, append, flush);
  const bool is_done = info != nullptr && encode(png, info, image, row.data(), channels);
  png_destroy_write_struct(&png, &info);
  if (!is_done) throw GoalError("the picture cannot be written as PNG: " + output.failure);
  return std::move(output.bytes);
}

}  // namespace transformesh
