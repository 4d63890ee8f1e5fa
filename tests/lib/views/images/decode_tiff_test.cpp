#include <doctest/doctest.h>
#include <sys/resource.h>
#include <tiffio.h>

#include <algorithm>

#include "helpers/encoded_images.h"
#include "views/images/image_file.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

constexpr int width = 37;
constexpr int height = 21;
constexpr std::size_t pixels = std::size_t{width} * height;

GrayImage decoded(const TiffKind& kind, const Rows& rows) {
  GrayImage image = decode_photograph(tiff_of(kind, width, height, rows), "a.tif");
  REQUIRE(image.width == width);
  REQUIRE(image.height == height);
  REQUIRE(image.pixels.size() == pixels);
  return image;
}

/// Returns the intensity of a sample of 8 bits or, in the machine's byte order, of 16.
double sample(const Rows& rows, std::size_t index, int bits) {
  if (bits == 8) return rows[index];
  return (rows[2 * index] + 256 * rows[2 * index + 1]) / 257.0;
}

/// Checks that the pixels of an image are the samples of the rows, with `samples` samples per
/// pixel.
void check_intensities(const GrayImage& image, const Rows& rows, const TiffKind& kind) {
  double largest = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::size_t first = i * static_cast<std::size_t>(kind.samples);
    const double intensity =
        kind.photometric == PHOTOMETRIC_RGB
            ? gray(sample(rows, first, kind.bits), sample(rows, first + 1, kind.bits),
                   sample(rows, first + 2, kind.bits))
            : sample(rows, first, kind.bits);
    largest = std::max(largest, std::abs(intensity - static_cast<double>(image.pixels[i])));
  }
  CHECK(largest < 1e-4);
}

std::size_t little_endian(const std::string& bytes, std::size_t place, std::size_t count) {
  std::size_t value = 0;
  while (count-- > 0) value = 256 * value + static_cast<unsigned char>(bytes[place + count]);
  return value;
}

/// Changes an existing label of a little-endian file.
void set_label(std::string& bytes, unsigned label, std::uint32_t value) {
  const std::size_t start = little_endian(bytes, 4, 4);
  const std::size_t labels = little_endian(bytes, start, 2);
  for (std::size_t i = 0; i < labels; ++i) {
    const std::size_t place = start + 2 + 12 * i;
    if (little_endian(bytes, place, 2) != label) continue;
    bytes[place + 2] = 4;  // whole numbers of four bytes
    for (std::size_t byte = 0; byte < 4; ++byte)
      bytes[place + 8 + byte] = static_cast<char>(value >> 8 * byte & 0xff);
    return;
  }
  FAIL("no such label");
}

/// Returns the peak memory of this process so far, in kB.
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

TEST_CASE("TIFF of gray and color, of 8 and 16 bits, in strips and tiles, of every compression") {
  for (const int bits : {8, 16}) {
    for (const int samples : {1, 2, 3, 4}) {
      const Rows rows = noise(pixels * static_cast<std::size_t>(samples * bits / 8));
      for (const int compression :
           {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
        for (const int tile : {0, 16}) {
          TiffKind kind{bits, samples, samples > 2 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK,
                        compression};
          kind.tile = tile;
          CAPTURE(bits);
          CAPTURE(samples);
          CAPTURE(compression);
          CAPTURE(tile);
          check_intensities(decoded(kind, rows), rows, kind);
        }
      }
    }
  }
}

TEST_CASE("TIFF of either byte order, with long offsets, and turned by its label") {
  const Rows rows = noise(pixels * 6);
  TiffKind kind{16, 3, PHOTOMETRIC_RGB};
  for (const char* mode : {"wl", "wb", "w8"}) {
    kind.mode = mode;
    CAPTURE(mode);
    check_intensities(decoded(kind, rows), rows, kind);
  }
  for (const int orientation : {2, 3, 4, 5, 6, 7, 8}) {
    kind.orientation = orientation;
    check_intensities(decoded(kind, rows), rows, kind);
  }
}

TEST_CASE("TIFF of white as 0") {
  for (const int bits : {8, 16}) {
    const TiffKind kind{bits, 1, PHOTOMETRIC_MINISWHITE};
    const Rows rows = noise(pixels * static_cast<std::size_t>(bits / 8));
    Rows reversed = rows;
    for (auto& byte : reversed) byte = static_cast<std::uint8_t>(~byte);
    check_intensities(decoded(kind, rows), reversed, kind);
  }
}

TEST_CASE("a TIFF of other samples is refused with advice") {
  TiffKind kind{32};
  kind.sample_format = SAMPLEFORMAT_IEEEFP;
  const Rows rows(std::size_t{4} * 4);
  CHECK(
      image_refusal(tiff_of(kind, 2, 2, rows)) ==
      "the format is TIFF with samples other than unsigned integers; only JPEG, PNG, TIFF and PNM "
      "of 8 or 16 bits are read: convert it first, for example with: magick a.image a.png "
      "(a.image)");
  kind.sample_format = SAMPLEFORMAT_UINT;
  CHECK(image_refusal(tiff_of(kind, 2, 2, rows)).find("32-bit samples") != std::string::npos);
  const auto refusal = [](const TiffKind& other, std::size_t bytes) {
    return image_refusal(tiff_of(other, 2, 2, Rows(bytes)));
  };
  for (const int bits : {1, 2, 4}) {
    const std::string text = refusal({bits, 1, PHOTOMETRIC_MINISBLACK}, 2);
    CHECK(text.find("TIFF of " + std::to_string(bits) + "-bit samples; only") != std::string::npos);
  }
  CHECK(refusal({8, 1, PHOTOMETRIC_PALETTE}, 4).find("other than gray or red, green and blue") !=
        std::string::npos);
  TiffKind apart{8, 3, PHOTOMETRIC_RGB};
  apart.planes = 2;
  CHECK(refusal(apart, 12).find("TIFF with channels in separate planes") != std::string::npos);
}

TEST_CASE("a TIFF that is cut short is refused, and damage does no harm") {
  for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_PACKBITS}) {
    CAPTURE(compression);
    const std::string bytes =
        tiff_of({8, 1, PHOTOMETRIC_MINISBLACK, compression}, 16, 13, noise(208));
    check_beginnings(bytes);
    check_damage(bytes);
  }
  TiffKind tiled{16, 3, PHOTOMETRIC_RGB, COMPRESSION_ADOBE_DEFLATE};
  tiled.tile = 16;
  check_damage(tiff_of(tiled, 19, 13, noise(19 * 13 * 6)));
}

TEST_CASE("a TIFF that claims more than its bytes can hold takes no memory") {
  const auto claim = [](const TiffKind& kind, std::uint32_t size) {
    std::string bytes = tiff_of(kind, 16, 2, noise(kind.bits == 1 ? 4 : 32));
    set_label(bytes, TIFFTAG_IMAGEWIDTH, size);
    set_label(bytes, TIFFTAG_IMAGELENGTH, size);
    return image_refusal(bytes);
  };
  const long before = peak_memory();
  CHECK(claim({8}, 20000).find("cannot be stored in") != std::string::npos);
  CHECK(claim({8}, 100000).find("too large") != std::string::npos);
  CHECK(claim({8}, 0) != "");
  CHECK(claim({8, 1, 1, COMPRESSION_LZW}, 20000) != "");
  CHECK(claim({8, 1, 3, COMPRESSION_LZW}, 20000) != "");
  CHECK(claim({1, 1, 0, COMPRESSION_CCITT_T6}, 20000) != "");
  CHECK(peak_memory() - before < 500000);
}

// Tiles are decoded as a whole; this one of 12 GB is in a file of less than 300 bytes.
TEST_CASE("a TIFF whose tile claims what its bytes cannot hold takes no memory for it") {
  TiffKind kind{16, 1, PHOTOMETRIC_MINISBLACK, COMPRESSION_ADOBE_DEFLATE};
  kind.tile = 16;
  std::string bytes = tiff_of(kind, 9, 5, noise(90));
  set_label(bytes, TIFFTAG_TILELENGTH, 23312);
  set_label(bytes, TIFFTAG_SAMPLESPERPIXEL, 16129);
  CHECK(image_refusal(bytes).starts_with(
      "a strip or tile of 12031975936 bytes cannot be stored in "));
}
