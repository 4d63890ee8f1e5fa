/// What decodes the formats of image files, each row by row into intensities. Internal to
/// image_file.
///
/// Memory is taken only as far as rows are decoded, so a file that claims more than it holds costs
/// nothing.
#pragma once

#include <cstdint>

#include "io/streams/source.h"
#include "picture/image.h"
#include "views/images/gray_image.h"

namespace transformesh {

/// How the samples of a file lie in its rows.
struct SampleLayout {
  int width = 0;
  int height = 0;
  int channels = 1;        ///< 1: gray; 3: red, green, blue
  int stride = 1;          ///< samples from pixel to pixel; those beyond the channels are left out
  double maximum = 255;    ///< the sample that is full intensity
  bool has_alpha = false;  ///< in the sample that follows the channels
};

/// Collects the intensities of an image, row by row from the top: of a silhouette the largest of
/// each pixel's channels, of a photograph their luma, of a picture all of them in 8 bits.
class IntensityRows {
 public:
  enum class Kind { photograph, silhouette, picture, size };

  explicit IntensityRows(Kind kind) : kind_(kind) {}

  /// Comes before the first row; false where none is wanted, as the size is all that was asked for.
  bool start(const SampleLayout& layout);
  void add(const std::uint8_t* row) { add_row(row); }
  void add(const std::uint16_t* row) { add_row(row); }
  GrayImage take() { return std::move(image_); }
  Image take_picture() { return std::move(picture_); }
  /// Of a silhouette, as far as the file has transparency: how opaque its pixels are, 0 to 255.
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

/// PNG of any color type and depth, by libpng. These throw InputError.
void decode_png(const Source& source, IntensityRows& rows);
/// Portable anymaps: P2, P3, P5 and P6.
void decode_pnm(const Source& source, IntensityRows& rows);
/// JPEG, by libjpeg. What its data lost is damage, although libjpeg would go on with a guess.
void decode_jpeg(const Source& source, IntensityRows& rows);
/// The first image of a TIFF file, by libtiff: gray and color samples of 8 and 16 bits, the
/// channels of a pixel side by side, in strips or tiles of any compression.
void decode_tiff(const Source& source, IntensityRows& rows);

/// Throws InputError unless width and height are at least 1, their product is at most 2^29, and
/// the bytes could hold so many pixels: at most `pixels_per_byte` in each.
void check_size(const Source& source, std::uint64_t width, std::uint64_t height,
                std::uint64_t pixels_per_byte);

/// Throws InputError that names the format, those that are read, and how to convert.
[[noreturn]] void refuse_format(const Source& source, const std::string& format);

}  // namespace transformesh
