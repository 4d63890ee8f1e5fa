/// Decoders of image formats, which pass rows of samples to IntensityRows. Used only by
/// image_file.cpp and the decoders.
///
/// Memory is allocated only while rows are decoded. A file with a false size in its header thus
/// uses little memory.
#pragma once

#include <cstdint>

#include "io/streams/source.h"
#include "transformesh/image.h"

namespace transformesh {

/// Layout of the samples in the rows of a file.
struct SampleLayout {
  int width = 0;
  int height = 0;
  int channels = 1;        ///< 1: gray; 3: red, green, blue
  int stride = 1;          ///< samples per pixel; samples beyond `channels` are ignored
  double maximum = 255;    ///< sample value of full intensity
  bool has_alpha = false;  ///< true if the sample after the channels is the opacity (alpha)
};

/// Collects the intensities of an image, row by row from the top. For a silhouette, the intensity
/// of a pixel is the maximum of its channels. For a photograph, it is the luma. For a picture, all
/// channels are stored with 8 bits.
class IntensityRows {
 public:
  enum class Kind { photograph, silhouette, picture, size };

  explicit IntensityRows(Kind kind) : kind_(kind) {}

  /// Must be called before the first row. Returns false if only the size is requested.
  bool start(const SampleLayout& layout);
  void add(const std::uint8_t* row) { add_row(row); }
  void add(const std::uint16_t* row) { add_row(row); }
  GrayImage take() { return std::move(image_); }
  Image take_picture() { return std::move(picture_); }
  /// Returns the opacity of the pixels of a silhouette, 0 to 255. The result is empty if the file
  /// has no alpha channel.
  GrayImage take_alpha() { return std::move(alpha_); }

 private:
  template <class Sample>
  void add_row(const Sample* row);
  template <class Sample>
  void add_picture_row(const Sample* row);

  Kind kind_;
  SampleLayout layout_;
  GrayImage image_;
  GrayImage alpha_;
  Image picture_;
};

/// Decodes PNG of any color type and depth, by libpng. All decoders throw InputError if the file is
/// malformed.
void decode_png(const Source& source, IntensityRows& rows);
/// Decodes portable anymaps of types P2, P3, P5 and P6.
void decode_pnm(const Source& source, IntensityRows& rows);
/// Decodes JPEG, by libjpeg. Throws InputError if data are missing; libjpeg alone would replace
/// them by a guess.
void decode_jpeg(const Source& source, IntensityRows& rows);
/// Decodes the first image of a TIFF file, by libtiff. Samples must be gray or RGB of 8 or 16 bits,
/// with interleaved channels, in strips or tiles of any compression.
void decode_tiff(const Source& source, IntensityRows& rows);

/// Throws InputError unless width and height are at least 1 and their product is at most 2^29. Also
/// throws if the bytes cannot contain this number of pixels, even with `pixels_per_byte` pixels per
/// byte.
void check_size(const Source& source, std::uint64_t width, std::uint64_t height,
                std::uint64_t pixels_per_byte);

/// Throws InputError because `format` is not supported. The message lists the supported formats and
/// explains how to convert the file.
[[noreturn]] void refuse_format(const Source& source, const std::string& format);

}  // namespace transformesh
