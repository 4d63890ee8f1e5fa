#include <png.h>

#include <bit>
#include <cstring>

#include "tm/views/images/samples.h"

namespace transformesh {
namespace {

struct Input {
  std::string_view rest;
  std::string failure;
};

void take(png_structp png, png_bytep data, png_size_t size) {
  auto* input = static_cast<Input*>(png_get_io_ptr(png));
  if (input->rest.size() < size) png_error(png, "the file ends too early");
  std::memcpy(data, input->rest.data(), size);
  input->rest.remove_prefix(size);
}

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  static_cast<Input*>(png_get_error_ptr(png))->failure = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

struct Layout {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  int channels = 0;
  int depth = 0;  ///< 8 or 16, of the samples that decode() writes
};

/// libpng leaves by longjmp: no object with a destructor may be made in here or in decode().
bool read_layout(png_structp png, png_infop info, Layout& layout) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_info(png, info);
  png_set_packing(png);
  png_set_expand_gray_1_2_4_to_8(png);
  png_set_palette_to_rgb(png);
  png_set_strip_alpha(png);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  layout.width = png_get_image_width(png, info);
  layout.height = png_get_image_height(png, info);
  layout.channels = png_get_channels(png, info);
  layout.depth = png_get_bit_depth(png, info);
  return true;
}

bool decode(png_structp png, png_infop info, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  png_read_end(png, info);
  return true;
}

/// Frees libpng's structures whatever happens.
class Reader {
 public:
  explicit Reader(const Source& source)
      : input_{source.bytes, {}},
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &input_, fail, ignore_warning)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &input_, take);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  bool read_layout(Layout& layout) { return transformesh::read_layout(png_, info_, layout); }
  bool decode(std::vector<png_bytep>& rows) {
    return transformesh::decode(png_, info_, rows.data());
  }
  const std::string& failure() const { return input_.failure; }

 private:
  Input input_;
  png_structp png_;
  png_infop info_;
};

/// Where each row of the samples starts.
std::vector<png_bytep> rows_of(Samples& samples) {
  auto* row =
      samples.is_deep() ? reinterpret_cast<png_bytep>(samples.deep.data()) : samples.shallow.data();
  const auto size = static_cast<std::size_t>(samples.width) *
                    static_cast<std::size_t>(samples.channels) * (samples.is_deep() ? 2U : 1U);
  std::vector<png_bytep> rows(static_cast<std::size_t>(samples.height));
  for (png_bytep& start : rows) {
    start = row;
    row += size;
  }
  return rows;
}

}  // namespace

Samples decode_png(const Source& source) {
  Reader reader(source);
  Layout layout;
  const auto refuse = [&] { source.fail("not a complete PNG image: " + reader.failure()); };
  if (!reader.read_layout(layout)) refuse();
  // Deflate makes a byte of at most 1032; a sample has one bit at least.
  check_size(source, layout.width, layout.height, std::uint64_t{8} * 1032);

  Samples samples;
  samples.width = static_cast<int>(layout.width);
  samples.height = static_cast<int>(layout.height);
  samples.channels = layout.channels;
  samples.maximum = layout.depth == 16 ? 65535 : 255;
  samples.allocate();
  std::vector<png_bytep> rows = rows_of(samples);
  if (!reader.decode(rows)) refuse();
  return samples;
}

}  // namespace transformesh
