#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include "tm/views/images/decoders.h"

namespace transformesh {
namespace {

/// The bytes, which libtiff reads as a file.
struct Input {
  std::string_view bytes;
  std::uint64_t place = 0;
  bool are_warnings_failures = false;
  std::string failure;  ///< the first message
};

Input& input_of(thandle_t handle) { return *static_cast<Input*>(handle); }

tmsize_t take(thandle_t handle, void* data, tmsize_t size) {
  Input& input = input_of(handle);
  if (size <= 0 || input.place >= input.bytes.size()) return 0;
  const auto taken =
      std::min<std::size_t>(static_cast<std::size_t>(size), input.bytes.size() - input.place);
  std::memcpy(data, input.bytes.data() + input.place, taken);
  input.place += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t refuse_to_write(thandle_t /*handle*/, void* /*data*/, tmsize_t /*size*/) { return -1; }

toff_t seek(thandle_t handle, toff_t offset, int from) {
  Input& input = input_of(handle);
  if (from == SEEK_CUR) offset += input.place;
  if (from == SEEK_END) offset += input.bytes.size();
  return input.place = offset;
}

int close(thandle_t /*handle*/) { return 0; }

toff_t size_of(thandle_t handle) { return input_of(handle).bytes.size(); }

int keep_failure(TIFF* /*tiff*/, void* input, const char* /*module*/, const char* format,
                 va_list values) {
  std::array<char, 200> text{};
  std::vsnprintf(text.data(), text.size(), format, values);
  std::string& failure = static_cast<Input*>(input)->failure;
  if (failure.empty()) failure = text.data();
  return 1;  // tells libtiff to print nothing
}

/// Where a file is opened, warnings tell of labels that libtiff does not know; later, of damage
/// that it fills by a guess.
int keep_warning(TIFF* tiff, void* input, const char* module, const char* format, va_list values) {
  if (!static_cast<Input*>(input)->are_warnings_failures) return 1;
  return keep_failure(tiff, input, module, format, values);
}

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

Tiff open(Input& input) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
      TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
  if (!options) throw std::bad_alloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_failure, &input);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keep_warning, &input);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), std::numeric_limits<std::int32_t>::max());
  return Tiff(TIFFClientOpenExt("image", "rm", &input, take, refuse_to_write, seek, close, size_of,
                                nullptr, nullptr, options.get()));
}

/// Samples that are not initialized, so that memory is touched only as far as libtiff decodes.
template <class Sample>
std::unique_ptr<Sample[]> samples(std::uint64_t count) {
  return std::unique_ptr<Sample[]>(new Sample[count]);
}

/// libtiff's conversion of whatever it knows to 8 bits of red, green, blue and alpha.
class Converter {
 public:
  Converter(TIFF* tiff, std::array<char, 1024>& reason)
      : is_ready_(TIFFRGBAImageBegin(&image_, tiff, 1, reason.data()) != 0) {
    // Pixels stay where the file has them, whatever it says of how to show them.
    image_.orientation = ORIENTATION_TOPLEFT;
    image_.req_orientation = ORIENTATION_TOPLEFT;
  }
  ~Converter() {
    if (is_ready_) TIFFRGBAImageEnd(&image_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  bool is_ready() const { return is_ready_; }
  /// The `count` rows from y, which are whole strips or tiles.
  bool read(std::uint32_t y, std::uint32_t count, std::uint32_t* pixels) {
    image_.row_offset = static_cast<int>(y);
    return TIFFRGBAImageGet(&image_, pixels, image_.width, count) != 0;
  }

 private:
  TIFFRGBAImage image_{};
  bool is_ready_;
};

/// Unpacks a row of gray samples of 1, 2 or 4 bits, the first in the highest bits of a byte.
template <class Sample>
void unpack(const Sample* packed, unsigned bits, std::vector<Sample>& row) {
  const unsigned per_byte = 8 / bits;
  for (std::size_t x = 0; x < row.size(); ++x) {
    const unsigned shift = 8 - bits * (1 + x % per_byte);
    row[x] = static_cast<Sample>(packed[x / per_byte] >> shift & ((1U << bits) - 1));
  }
}

/// Unpacks a row of pixels into samples of red, green and blue.
void unpack(const std::uint32_t* pixel, std::vector<std::uint8_t>& row) {
  for (auto sample = row.begin(); sample != row.end(); sample += 3, ++pixel) {
    sample[0] = static_cast<std::uint8_t>(TIFFGetR(*pixel));
    sample[1] = static_cast<std::uint8_t>(TIFFGetG(*pixel));
    sample[2] = static_cast<std::uint8_t>(TIFFGetB(*pixel));
  }
}

class Reader {
 public:
  explicit Reader(const Source& source)
      : source_(source), input_{source.bytes, 0, false, {}}, tiff_(open(input_)) {
    if (!tiff_) refuse();
    width_ = field<std::uint32_t>(TIFFTAG_IMAGEWIDTH);
    height_ = field<std::uint32_t>(TIFFTAG_IMAGELENGTH);
    bits_ = field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    stride_ = field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
    photometric_ = field<std::uint16_t>(TIFFTAG_PHOTOMETRIC);
    is_tiled_ = TIFFIsTiled(tiff_.get()) != 0;
    // No bound is known for compressed data, which show what they hold when they are decoded.
    constexpr std::uint64_t any = std::numeric_limits<std::uint32_t>::max();
    const bool is_compressed = field<std::uint16_t>(TIFFTAG_COMPRESSION) != COMPRESSION_NONE;
    check_size(source, width_, height_, is_compressed ? any : 8);
    if (is_tiled_)
      check_size(source, field<std::uint32_t>(TIFFTAG_TILEWIDTH),
                 field<std::uint32_t>(TIFFTAG_TILELENGTH), any);
    input_.are_warnings_failures = true;
  }

  void read(LevelRows& rows) {
    if (field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT) != SAMPLEFORMAT_UINT)
      refuse_format(source_, "TIFF of samples that are no unsigned integers");
    if (!are_samples_plain()) return read_converted(rows);
    rows.start({static_cast<int>(width_), static_cast<int>(height_), is_gray() ? 1 : 3, stride_,
                static_cast<double>(maximum())});
    bits_ == 16 ? read_plain<std::uint16_t>(rows) : read_plain<std::uint8_t>(rows);
  }

 private:
  template <class Value>
  Value field(std::uint32_t tag) const {
    Value value = 0;
    TIFFGetFieldDefaulted(tiff_.get(), tag, &value);
    return value;
  }

  [[noreturn]] void refuse() const {
    source_.fail("not a complete TIFF image: " +
                 (input_.failure.empty() ? "libtiff finds none" : input_.failure));
  }
  void demand(bool is_done) const {
    if (!is_done || !input_.failure.empty()) refuse();
  }

  bool is_gray() const {
    return photometric_ == PHOTOMETRIC_MINISBLACK || photometric_ == PHOTOMETRIC_MINISWHITE;
  }

  unsigned maximum() const { return (1U << bits_) - 1; }

  /// Whether levels can be made of the samples as they are in the file.
  bool are_samples_plain() const {
    const bool are_bytes = bits_ == 8 || bits_ == 16;
    const bool are_bits = bits_ == 1 || bits_ == 2 || bits_ == 4;
    const bool is_color = photometric_ == PHOTOMETRIC_RGB && stride_ >= 3;
    const bool are_together = field<std::uint16_t>(TIFFTAG_PLANARCONFIG) == PLANARCONFIG_CONTIG;
    if (stride_ == 1) return is_gray() && (are_bytes || (are_bits && !is_tiled_));
    return (is_gray() || is_color) && are_bytes && are_together;
  }

  /// Strips and rows of tiles are bands of so many rows.
  std::uint32_t rows_per_band() const {
    const auto rows = field<std::uint32_t>(is_tiled_ ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP);
    return std::clamp(rows, 1U, height_);
  }

  /// Calls read(first row, number of rows) for each band.
  template <class Read>
  void for_each_band(const Read& read) const {
    const std::uint32_t most = rows_per_band();
    for (std::uint32_t y = 0; y < height_; y += std::min(most, height_ - y))
      read(y, std::min(most, height_ - y));
  }

  template <class Sample>
  void read_plain(LevelRows& rows) {
    const std::uint64_t row_size = std::uint64_t{width_} * stride_;
    const auto band = samples<Sample>(rows_per_band() * row_size);
    std::vector<Sample> row(row_size);
    for_each_band([&](std::uint32_t y, std::uint32_t count) {
      is_tiled_ ? read_tiles(y, count, band.get()) : read_strip(y, count, band.get());
      for (std::uint32_t i = 0; i < count; ++i) {
        bits_ < 8 ? unpack(band.get() + i * ((row_size * bits_ + 7) / 8), bits_, row)
                  : void(std::copy_n(band.get() + i * row_size, row_size, row.begin()));
        if (photometric_ == PHOTOMETRIC_MINISWHITE)
          for (Sample& sample : row) sample = static_cast<Sample>(maximum() - sample);
        rows.add(row.data());
      }
    });
  }

  void read_strip(std::uint32_t y, std::uint32_t count, void* band) const {
    const std::uint64_t row_bits = std::uint64_t{width_} * stride_ * bits_;
    const auto size = static_cast<tmsize_t>(count * ((row_bits + 7) / 8));
    const std::uint32_t strip = TIFFComputeStrip(tiff_.get(), y, 0);
    demand(TIFFReadEncodedStrip(tiff_.get(), strip, band, size) == size);
  }

  template <class Sample>
  void read_tiles(std::uint32_t y, std::uint32_t count, Sample* band) const {
    const auto tile_width = field<std::uint32_t>(TIFFTAG_TILEWIDTH);
    const tmsize_t size = TIFFTileSize(tiff_.get());
    const auto tile = samples<Sample>(static_cast<std::uint64_t>(size) / sizeof(Sample));
    for (std::uint32_t x = 0; x < width_; x += std::min(tile_width, width_ - x)) {
      const std::uint32_t index = TIFFComputeTile(tiff_.get(), x, y, 0, 0);
      demand(TIFFReadEncodedTile(tiff_.get(), index, tile.get(), size) == size);
      const std::uint64_t length = std::uint64_t{std::min(tile_width, width_ - x)} * stride_;
      for (std::uint64_t i = 0; i < count; ++i)
        std::copy_n(tile.get() + i * tile_width * stride_, length,
                    band + (i * width_ + x) * stride_);
    }
  }

  void read_converted(LevelRows& rows) {
    std::array<char, 1024> reason{};  // libtiff asks for this size
    if (TIFFRGBAImageOK(tiff_.get(), reason.data()) == 0)
      refuse_format(source_, "TIFF (" + std::string(reason.data()) + ")");
    Converter converter(tiff_.get(), reason);
    demand(converter.is_ready());
    rows.start({static_cast<int>(width_), static_cast<int>(height_), 3, 3, 255});
    const auto band = samples<std::uint32_t>(std::uint64_t{rows_per_band()} * width_);
    std::vector<std::uint8_t> row(std::size_t{3} * width_);
    for_each_band([&](std::uint32_t y, std::uint32_t count) {
      demand(converter.read(y, count, band.get()));
      for (std::uint32_t i = 0; i < count; ++i) {
        unpack(band.get() + std::uint64_t{i} * width_, row);
        rows.add(row.data());
      }
    });
  }

  const Source& source_;
  Input input_;
  Tiff tiff_;
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::uint16_t bits_ = 0;
  std::uint16_t stride_ = 0;  ///< samples per pixel
  std::uint16_t photometric_ = 0;
  bool is_tiled_ = false;
};

}  // namespace

void decode_tiff(const Source& source, LevelRows& rows) { Reader(source).read(rows); }

}  // namespace transformesh
