#include <png.h>

#include <bit>
#include <cstring>
#include <memory>

#include "views/images/decoders.h"

namespace transformesh {
namespace {

struct PngInput {
  std::string_view rest;
  std::string failure;
};

void take_png_bytes(png_structp png, png_bytep data, png_size_t size) {
  auto* input = static_cast<PngInput*>(png_get_io_ptr(png));
  if (input->rest.size() < size) png_error(png, "the file ends too early");
  std::memcpy(data, input->rest.data(), size);
  input->rest.remove_prefix(size);
}

[[noreturn]] void fail_in_libpng(png_structp png, png_const_charp message) {
  static_cast<PngInput*>(png_get_error_ptr(png))->failure = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

/// Calls `action`. Returns false if libpng fails in it. libpng then leaves `action` by longjmp, so
/// that `action` must not create objects with destructors.
template <class Action>
bool completes(png_structp png, const Action& action) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  action();
  return true;
}

void read_header(png_structp png, png_infop info) {
  png_read_info(png, info);
  png_set_packing(png);
  png_set_expand_gray_1_2_4_to_8(png);
  png_set_palette_to_rgb(png);
  // Convert transparent colors and palette entries to an alpha channel, for masks.
  png_set_tRNS_to_alpha(png);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
}

/// Owns libpng's structures.
class PngReader {
 public:
  explicit PngReader(const Source& source)
      : source_(source),
        input_{source.bytes, {}},
        png_(
            png_create_read_struct(PNG_LIBPNG_VER_STRING, &input_, fail_in_libpng, ignore_warning)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &input_, take_png_bytes);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  SampleLayout read_layout() {
    demand([this] { read_header(png_, info_); });
    const auto width = png_get_image_width(png_, info_);
    const auto height = png_get_image_height(png_, info_);
    // Limit of pixels per byte of the file: PNG's compression (deflate) expands one byte to at most
    // 1032 bytes.
    const unsigned bits = png_get_channels(png_, info_) * png_get_bit_depth(png_, info_);
    check_size(source_, width, height, std::uint64_t{8} * 1032 / bits);
    demand([this] {
      passes_ = png_set_interlace_handling(png_);
      png_read_update_info(png_, info_);
    });
    const int samples = png_get_channels(png_, info_);
    const bool has_alpha = samples % 2 == 0;
    return {static_cast<int>(width),
            static_cast<int>(height),
            samples - (has_alpha ? 1 : 0),
            samples,
            png_get_bit_depth(png_, info_) == 16 ? 65535.0 : 255.0,
            has_alpha};
  }

  void read(const SampleLayout& layout, IntensityRows& rows) {
    const auto height = static_cast<std::size_t>(layout.height);
    const std::size_t row_size = png_get_rowbytes(png_, info_);
    // Interlaced images need memory for all rows, because no row is complete before the last pass.
    // The memory is not initialized, so that only the part that libpng decodes is really used.
    // NOLINTNEXTLINE(*-avoid-c-arrays)
    const std::unique_ptr<png_byte[]> samples(
        new png_byte[passes_ == 1 ? row_size : height * row_size]);
    for (int pass = 1; pass < passes_; ++pass) read_pass(height, row_size, samples.get());
    for (std::size_t y = 0; y < height; ++y) {
      png_bytep row = samples.get() + (passes_ == 1 ? 0 : y * row_size);
      demand([&] { png_read_row(png_, row, nullptr); });
      layout.maximum > 255 ? rows.add(reinterpret_cast<const std::uint16_t*>(row)) : rows.add(row);
    }
    demand([this] { png_read_end(png_, nullptr); });
  }

 private:
  template <class Action>
  void demand(const Action& action) {
    if (!completes(png_, action)) source_.fail("not a complete PNG image: " + input_.failure);
  }
  void read_pass(std::size_t height, std::size_t row_size, png_bytep samples) {
    demand([&] {
      for (std::size_t y = 0; y < height; ++y) png_read_row(png_, samples + y * row_size, nullptr);
    });
  }

  const Source& source_;
  PngInput input_;
  png_structp png_;
  png_infop info_;
  int passes_ = 1;
};

}  // namespace

void decode_png(const Source& source, IntensityRows& rows) {
  PngReader reader(source);
  const SampleLayout layout = reader.read_layout();
  if (rows.start(layout)) reader.read(layout, rows);
}

}  // namespace transformesh
