#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include "support/counted.h"
#include "views/images/decoders.h"

namespace transformesh {
namespace {

/// Bytes in memory that libtiff reads as a file.
struct TiffInput {
  std::string_view bytes;
  std::uint64_t place = 0;
  bool are_warnings_failures = false;
  std::string failure;  ///< the first error message of libtiff
};

TiffInput& input_of(thandle_t handle) { return *static_cast<TiffInput*>(handle); }

tmsize_t take_tiff_bytes(thandle_t handle, void* data, tmsize_t size) {
  TiffInput& input = input_of(handle);
  if (size <= 0 || input.place >= input.bytes.size()) return 0;
  const auto taken =
      std::min<std::size_t>(static_cast<std::size_t>(size), input.bytes.size() - input.place);
  std::memcpy(data, input.bytes.data() + input.place, taken);
  input.place += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t refuse_to_write(thandle_t /*handle*/, void* /*data*/, tmsize_t /*size*/) { return -1; }

toff_t seek(thandle_t handle, toff_t offset, int from) {
  TiffInput& input = input_of(handle);
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
  std::string& failure = static_cast<TiffInput*>(input)->failure;
  if (failure.empty()) failure = text.data();
  return 1;  // libtiff prints nothing
}

/// Handles warnings of libtiff. When a file is opened, they concern unknown tags and are ignored.
/// Later they concern damaged data that libtiff replaces by a guess, and are errors.
int keep_warning(TIFF* tiff, void* input, const char* module, const char* format, va_list values) {
  if (!static_cast<TiffInput*>(input)->are_warnings_failures) return 1;
  return keep_failure(tiff, input, module, format, values);
}

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

Tiff open(TiffInput& input) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
      TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
  if (!options) throw std::bad_alloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_failure, &input);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keep_warning, &input);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), std::numeric_limits<std::int32_t>::max());
  return Tiff(TIFFClientOpenExt("image", "rm", &input, take_tiff_bytes, refuse_to_write, seek,
                                close, size_of, nullptr, nullptr, options.get()));
}

/// Returns uninitialized memory for `count` samples. The system then provides physical memory only
/// for the part that libtiff decodes.
template <class Sample>  // NOLINTNEXTLINE(*-avoid-c-arrays)
std::unique_ptr<Sample[]> samples(std::uint64_t count) {
  // NOLINTNEXTLINE(*-avoid-c-arrays)
  return std::unique_ptr<Sample[]>(new Sample[count]);
}

class TiffReader {
 public:
  explicit TiffReader(const Source& source)
      : source_(source), input_{source.bytes, 0, false, {}}, tiff_(open(input_)) {
    if (!tiff_) refuse();
    width_ = field<std::uint32_t>(TIFFTAG_IMAGEWIDTH);
    height_ = field<std::uint32_t>(TIFFTAG_IMAGELENGTH);
    bits_ = field<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    stride_ = field<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
    photometric_ = field<std::uint16_t>(TIFFTAG_PHOTOMETRIC);
    is_tiled_ = TIFFIsTiled(tiff_.get()) != 0;
    // For compressed data, the number of pixels per byte is not limited here; missing data are
    // noticed during decoding.
    constexpr std::uint64_t any = std::numeric_limits<std::uint32_t>::max();
    const bool is_compressed = field<std::uint16_t>(TIFFTAG_COMPRESSION) != COMPRESSION_NONE;
    check_size(source, width_, height_, is_compressed ? any : 8);
    if (is_tiled_)
      check_size(source, field<std::uint32_t>(TIFFTAG_TILEWIDTH),
                 field<std::uint32_t>(TIFFTAG_TILELENGTH), any);
    input_.are_warnings_failures = true;
  }

  void read(IntensityRows& rows) {
    check_kind();
    const int channels = is_gray() ? 1 : 3;
    const bool wants_rows =
        rows.start({static_cast<int>(width_), static_cast<int>(height_), channels, stride_,
                    bits_ == 16 ? 65535.0 : 255.0, stride_ == channels + 1 && has_alpha()});
    if (!wants_rows) return;
    bits_ == 16 ? read_bands<std::uint16_t>(rows) : read_bands<std::uint8_t>(rows);
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

  bool has_alpha() const {
    std::uint16_t count = 0;
    const std::uint16_t* kinds = nullptr;
    const bool is_given = TIFFGetField(tiff_.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds) != 0;
    return is_given && count == 1 && kinds[0] != EXTRASAMPLE_UNSPECIFIED;
  }

  bool is_gray() const {
    return photometric_ == PHOTOMETRIC_MINISBLACK || photometric_ == PHOTOMETRIC_MINISWHITE;
  }

  void check_kind() const {
    if (field<std::uint16_t>(TIFFTAG_SAMPLEFORMAT) != SAMPLEFORMAT_UINT)
      refuse_format(source_, "TIFF with samples other than unsigned integers");
    if (bits_ != 8 && bits_ != 16)
      refuse_format(source_, "TIFF of " + std::to_string(bits_) + "-bit samples");
    if (!is_gray() && (photometric_ != PHOTOMETRIC_RGB || stride_ < 3))
      refuse_format(source_, "TIFF with samples other than gray or red, green and blue");
    if (stride_ > 1 && field<std::uint16_t>(TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG)
      refuse_format(source_, "TIFF with channels in separate planes");
  }

  /// Returns the number of pixel rows that are decoded together: those of a strip or of a row of
  /// tiles.
  std::uint32_t rows_per_band() const {
    const auto rows = field<std::uint32_t>(is_tiled_ ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP);
    return std::clamp(rows, 1U, height_);
  }

  /// Allocates memory for a strip or tile, which libtiff decodes as a whole. The memory is thus
  /// allocated before missing data are noticed. Throws InputError if the file is too small for such
  /// a strip or tile. No common compression reduces a photograph by a factor of 2^16.
  template <class Sample>
  std::unique_ptr<Sample[]> claimed_samples(std::uint64_t count) const {  // NOLINT(*-c-arrays)
    constexpr std::uint64_t always_fine = 1 << 24;  // bytes that may be allocated for any file
    // Largest number of decoded bytes per byte of the file, for the strongest compression.
    constexpr std::uint64_t most_of_a_byte = 1 << 16;
    const std::uint64_t size = sizeof(Sample) * count;
    if (size > std::max(always_fine, most_of_a_byte * source_.bytes.size())) {
      source_.fail("a strip or tile of " + counted(size, "byte") + " cannot be stored in " +
                   counted(source_.bytes.size(), "byte"));
    }
    return samples<Sample>(count);
  }

  template <class Sample>
  void read_bands(IntensityRows& rows) {
    const std::uint64_t row_size = std::uint64_t{width_} * stride_;
    const std::uint32_t most = rows_per_band();
    const auto band = claimed_samples<Sample>(most * row_size);
    std::vector<Sample> row(row_size);
    for (std::uint32_t y = 0, count = 0; y < height_; y += count) {
      count = std::min(most, height_ - y);
      is_tiled_ ? read_tiles(y, count, band.get()) : read_strip(y, count, band.get());
      for (std::uint32_t i = 0; i < count; ++i) {
        std::copy_n(band.get() + i * row_size, row_size, row.begin());
        if (photometric_ == PHOTOMETRIC_MINISWHITE)
          for (std::size_t x = 0; x < row_size; x += stride_) row[x] = static_cast<Sample>(~row[x]);
        rows.add(row.data());
      }
    }
  }

  template <class Sample>
  void read_strip(std::uint32_t y, std::uint32_t count, Sample* band) const {
    const auto size = static_cast<tmsize_t>(sizeof(Sample) * count * width_ * stride_);
    const std::uint32_t strip = TIFFComputeStrip(tiff_.get(), y, 0);
    demand(TIFFReadEncodedStrip(tiff_.get(), strip, band, size) == size);
  }

  template <class Sample>
  void read_tiles(std::uint32_t y, std::uint32_t count, Sample* band) const {
    const auto tile_width = field<std::uint32_t>(TIFFTAG_TILEWIDTH);
    const tmsize_t size = TIFFTileSize(tiff_.get());
    const auto tile = claimed_samples<Sample>(static_cast<std::uint64_t>(size) / sizeof(Sample));
    for (std::uint32_t x = 0; x < width_; x += std::min(tile_width, width_ - x)) {
      const std::uint32_t index = TIFFComputeTile(tiff_.get(), x, y, 0, 0);
      demand(TIFFReadEncodedTile(tiff_.get(), index, tile.get(), size) == size);
      const std::uint64_t length = std::uint64_t{std::min(tile_width, width_ - x)} * stride_;
      for (std::uint64_t i = 0; i < count; ++i)
        std::copy_n(tile.get() + i * tile_width * stride_, length,
                    band + (i * width_ + x) * stride_);
    }
  }

  const Source& source_;
  TiffInput input_;
  Tiff tiff_;
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::uint16_t bits_ = 0;
  std::uint16_t stride_ = 0;  ///< samples per pixel
  std::uint16_t photometric_ = 0;
  bool is_tiled_ = false;
};

}  // namespace

void decode_tiff(const Source& source, IntensityRows& rows) { TiffReader(source).read(rows); }

}  // namespace transformesh
