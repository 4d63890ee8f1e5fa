/// Encodes image files in memory with the codec libraries, for tests of the decoders.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace transformesh::test {

/// Packed rows of samples in the order of the file, from the top.
using Rows = std::vector<std::uint8_t>;

/// Returns random bytes, the same in every run.
Rows noise(std::size_t count);

struct JpegKind {
  int channels = 3;  ///< 1: gray, 3: color, 4: inverted CMYK, as Adobe's programs write it
  bool is_progressive = false;
  unsigned restart_interval = 0;
};
std::string jpeg_of(const JpegKind& kind, int width, int height, const Rows& rows);

struct PngKind {
  int color_type;
  int depth;
  bool is_interlaced = false;
};
/// Palettes have the colors (10, 20, 30) and (200, 100, 50).
std::string png_of(const PngKind& kind, int width, int height, Rows rows);

struct TiffKind {
  int bits = 8;
  int samples = 1;  ///< number of samples per pixel
  int photometric =
      1;  ///< tag PhotometricInterpretation; 0: white is 0, 1: black is 0, 2: color, 3: palette
  int compression = 1;  ///< tag Compression; 1: none
  int planes = 1;       ///< tag PlanarConfiguration; 2: all red samples come first
  int tile = 0;         ///< width and height of tiles in pixels; 0: strips of two rows
  int orientation = 1;
  int sample_format = 1;
  /// Mode of TIFFClientOpen(); "wb": big-endian; "w8": with offsets of 8 bytes.
  const char* mode = "w";
};
/// Palettes map index i to the color (257 i, 0, 0).
std::string tiff_of(const TiffKind& kind, int width, int height, Rows rows);

/// Returns the error message for a file; empty if it is decoded.
std::string image_refusal(const std::string& bytes);

/// Checks that every truncated copy of the file is refused with a message that names the file.
void check_beginnings(const std::string& bytes);

/// Checks that each copy of the file with random changes is decoded, or refused with a message that
/// names the file.
void check_damage(const std::string& bytes);

double gray(double red, double green, double blue);

}  // namespace transformesh::test
