#include <csetjmp>
#include <cstdio>
// jpeglib.h takes its types from stdio.h.
#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <new>
#include <vector>

#include "views/images/decoders.h"

namespace transformesh {
namespace {

/// Largest accepted number of scans in a file. Each scan processes the whole image, so that a small
/// file with many scans could take hours. Progressive images have about ten scans.
constexpr int most_scans = 100;

struct ErrorManager {
  jpeg_error_mgr base{};  ///< must be first: libjpeg accesses only this part
  std::jmp_buf escape{};
  std::array<char, JMSG_LENGTH_MAX> reason{};
};

[[noreturn]] void fail_in_libjpeg(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<ErrorManager*>(jpeg->err);
  jpeg->err->format_message(jpeg, errors->reason.data());
  std::longjmp(errors->escape, 1);
}

[[noreturn]] void fail_early(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<ErrorManager*>(jpeg->err);
  errors->reason = {"the file ends too early"};
  std::longjmp(errors->escape, 1);
}

/// Treats warnings as errors, because libjpeg would replace damaged data by a guess. Ignores a few
/// warnings that concern only metadata.
void take_message(j_common_ptr jpeg, int intensity) {
  constexpr int warning = -1;  // libjpeg's message level for warnings
  if (intensity != warning) return;
  switch (jpeg->err->msg_code) {
    case JWRN_ADOBE_XFORM:
    case JWRN_BOGUS_PROGRESSION:
    case JWRN_JFIF_MAJOR:
    case JWRN_NOT_SEQUENTIAL:
      return;
    case JWRN_JPEG_EOF:
      fail_early(jpeg);
    default:
      fail_in_libjpeg(jpeg);
  }
}

void ignore_message(j_common_ptr /*jpeg*/) {}

void count_scans(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= most_scans) return;
  auto* errors = reinterpret_cast<ErrorManager*>(jpeg->err);
  errors->reason = {"it has more than 100 scans"};
  std::longjmp(errors->escape, 1);
}

/// Owns libjpeg's structures.
class JpegReader {
 public:
  explicit JpegReader(const Source& source) : source_(source) {
    jpeg_.err = jpeg_std_error(&errors_.base);
    errors_.base.error_exit = fail_in_libjpeg;
    errors_.base.emit_message = take_message;
    errors_.base.output_message = ignore_message;
    progress_.progress_monitor = count_scans;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  SampleLayout read_layout() {
    demand([this] {
      jpeg_create_decompress(&jpeg_);
      jpeg_.progress = &progress_;
      jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(source_.bytes.data()),
                   source_.bytes.size());
      jpeg_read_header(&jpeg_, TRUE);
    });
    // JPEG codes blocks of 8 x 8 samples, and each block takes at least one bit. With chroma
    // subsampling, a block of one component may cover 128 pixels.
    check_size(source_, jpeg_.image_width, jpeg_.image_height, std::uint64_t{8} * 128);
    if (jpeg_.num_components == 4)
      jpeg_.out_color_space = JCS_CMYK;
    else if (jpeg_.num_components != 1)
      jpeg_.out_color_space = JCS_RGB;
    demand([this] { jpeg_calc_output_dimensions(&jpeg_); });
    const int channels = jpeg_.output_components == 1 ? 1 : 3;
    return {static_cast<int>(jpeg_.output_width), static_cast<int>(jpeg_.output_height), channels,
            jpeg_.output_components, 255};
  }

  void read(IntensityRows& rows) {
    demand([this] { jpeg_start_decompress(&jpeg_); });
    std::vector<JSAMPLE> row(std::size_t{jpeg_.output_width} *
                             static_cast<std::size_t>(jpeg_.output_components));
    JSAMPROW start = row.data();
    while (jpeg_.output_scanline < jpeg_.output_height) {
      demand([this, &start] { jpeg_read_scanlines(&jpeg_, &start, 1); });
      if (jpeg_.output_components == 4) convert_from_cmyk(row);
      rows.add(row.data());
    }
    demand([this] { jpeg_finish_decompress(&jpeg_); });
  }

 private:
  /// Calls libjpeg and throws if it fails. libjpeg leaves `action` by longjmp, so that `action`
  /// must not create objects with destructors.
  template <class Action>
  void demand(const Action& action) {
    if (setjmp(errors_.escape) != 0) refuse();
    action();
  }
  [[noreturn]] void refuse() const {
    if (errors_.base.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
    const std::string row =
        jpeg_.output_scanline > 0 ? ", in row " + std::to_string(jpeg_.output_scanline + 1) : "";
    source_.fail("not a complete JPEG image: " + std::string(errors_.reason.data()) + row);
  }

  /// Converts inverted CMYK, as Adobe's programs write it, to RGB.
  static void convert_from_cmyk(std::vector<JSAMPLE>& row) {
    for (auto pixel = row.begin(); pixel != row.end(); pixel += 4) {
      const int black = pixel[3];
      for (int i = 0; i < 3; ++i)
        pixel[i] = static_cast<JSAMPLE>(black - ((255 - pixel[i]) * black >> 8));
    }
  }

  const Source& source_;
  ErrorManager errors_;
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct jpeg_{};
};

}  // namespace

void decode_jpeg(const Source& source, IntensityRows& rows) {
  JpegReader reader(source);
  if (rows.start(reader.read_layout())) reader.read(rows);
}

}  // namespace transformesh
