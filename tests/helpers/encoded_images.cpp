#include "helpers/encoded_images.h"

#include <png.h>
#include <tiffio.h>

#include <cstdio>
#include <cstdlib>
// jpeglib.h needs types of stdio.h, which must be included before it.
#include <jpeglib.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "helpers/random.h"
#include "transformesh/errors.h"
#include "views/images/image_file.h"

namespace transformesh::test {
namespace {

void append_png(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(data), size);
}

/// A file in memory that libtiff writes.
struct MemoryFile {
  std::string bytes;
  std::size_t place = 0;
};

MemoryFile& file_of(thandle_t handle) { return *static_cast<MemoryFile*>(handle); }

tmsize_t read(thandle_t handle, void* data, tmsize_t size) {
  MemoryFile& file = file_of(handle);
  const std::size_t read = std::min(static_cast<std::size_t>(size), file.bytes.size() - file.place);
  std::memcpy(data, file.bytes.data() + file.place, read);
  file.place += read;
  return static_cast<tmsize_t>(read);
}

tmsize_t write(thandle_t handle, void* data, tmsize_t size) {
  MemoryFile& file = file_of(handle);
  const auto count = static_cast<std::size_t>(size);
  file.bytes.resize(std::max(file.bytes.size(), file.place + count));
  std::memcpy(file.bytes.data() + file.place, data, count);
  file.place += count;
  return size;
}

toff_t seek(thandle_t handle, toff_t offset, int from) {
  MemoryFile& file = file_of(handle);
  if (from == SEEK_CUR) offset += file.place;
  if (from == SEEK_END) offset += file.bytes.size();
  return file.place = offset;
}

int close(thandle_t /*handle*/) { return 0; }

toff_t size_of(thandle_t handle) { return file_of(handle).bytes.size(); }

void set_labels(TIFF* tiff, const TiffKind& kind, int width, int height) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, kind.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, kind.samples);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, kind.photometric);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.compression);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, kind.planes);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, kind.orientation);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, kind.sample_format);
  if (kind.samples == 2 || kind.samples == 4) {
    const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &alpha);
  }
  if (kind.photometric == PHOTOMETRIC_PALETTE) {
    std::array<std::uint16_t, 256> red{};
    std::array<std::uint16_t, 256> none{};
    for (std::size_t i = 0; i < red.size(); ++i) red[i] = static_cast<std::uint16_t>(257 * i);
    TIFFSetField(tiff, TIFFTAG_COLORMAP, red.data(), none.data(), none.data());
  }
  if (kind.tile == 0) TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2);
  if (kind.tile > 0) TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kind.tile);
  if (kind.tile > 0) TIFFSetField(tiff, TIFFTAG_TILELENGTH, kind.tile);
}

void write_strips(TIFF* tiff, const TiffKind& kind, int height, Rows& rows) {
  const auto size = static_cast<std::size_t>(TIFFScanlineSize(tiff));
  const int planes = kind.planes == 2 ? kind.samples : 1;
  REQUIRE(rows.size() == size * static_cast<std::size_t>(height * planes));
  std::uint8_t* row = rows.data();
  for (int plane = 0; plane < planes; ++plane) {
    for (int y = 0; y < height; ++y, row += size) {
      REQUIRE(TIFFWriteScanline(tiff, row, static_cast<unsigned>(y),
                                static_cast<std::uint16_t>(plane)) == 1);
    }
  }
}

void write_tiles(TIFF* tiff, const TiffKind& kind, int width, int height, const Rows& rows) {
  const int pixel = kind.samples * kind.bits / 8;
  Rows tile(static_cast<std::size_t>(TIFFTileSize(tiff)));
  for (int top = 0; top < height; top += kind.tile) {
    for (int left = 0; left < width; left += kind.tile) {
      const int columns = std::min(kind.tile, width - left);
      for (int y = 0; y < std::min(kind.tile, height - top); ++y) {
        std::copy_n(rows.begin() + ((top + y) * width + left) * pixel, columns * pixel,
                    tile.begin() + y * kind.tile * pixel);
      }
      TIFFWriteTile(tiff, tile.data(), static_cast<unsigned>(left), static_cast<unsigned>(top), 0,
                    0);
    }
  }
}

}  // namespace

Rows noise(std::size_t count) {
  Random random(2);
  Rows rows(count);
  for (std::uint8_t& byte : rows) byte = static_cast<std::uint8_t>(random.below(256));
  return rows;
}

std::string jpeg_of(const JpegKind& kind, int width, int height, const Rows& rows) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &data, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = kind.channels;
  jpeg.in_color_space = kind.channels == 1   ? JCS_GRAYSCALE
                        : kind.channels == 3 ? JCS_RGB
                                             : JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  if (kind.is_progressive) jpeg_simple_progression(&jpeg);
  jpeg.restart_interval = kind.restart_interval;
  jpeg_start_compress(&jpeg, TRUE);
  const std::size_t row_size = static_cast<std::size_t>(width * kind.channels);
  REQUIRE(rows.size() == row_size * static_cast<std::size_t>(height));
  while (jpeg.next_scanline < jpeg.image_height) {
    auto* row = const_cast<JSAMPROW>(rows.data() + jpeg.next_scanline * row_size);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  const std::string bytes(reinterpret_cast<char*>(data), size);
  jpeg_destroy_compress(&jpeg);
  std::free(data);
  return bytes;
}

std::string png_of(const PngKind& kind, int width, int height, Rows rows) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append_png, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
               kind.depth, kind.color_type,
               kind.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const std::array<png_color, 2> palette{png_color{10, 20, 30}, png_color{200, 100, 50}};
  if (kind.color_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), 2);
  png_set_gAMA(png, info, 0.45455);
  png_write_info(png, info);
  const std::size_t row_size = png_get_rowbytes(png, info);
  REQUIRE(rows.size() == row_size * static_cast<std::size_t>(height));
  std::vector<png_bytep> pointers;
  for (int y = 0; y < height; ++y) {
    pointers.push_back(rows.data() + static_cast<std::size_t>(y) * row_size);
  }
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

std::string tiff_of(const TiffKind& kind, int width, int height, Rows rows) {
  MemoryFile file;
  TIFF* tiff =
      TIFFClientOpen("test", kind.mode, &file, read, write, seek, close, size_of, nullptr, nullptr);
  REQUIRE(tiff != nullptr);
  set_labels(tiff, kind, width, height);
  kind.tile > 0 ? write_tiles(tiff, kind, width, height, rows)
                : write_strips(tiff, kind, height, rows);
  TIFFClose(tiff);
  return file.bytes;
}

std::string image_refusal(const std::string& bytes) {
  try {
    decode_photograph(bytes, "a.image");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void check_beginnings(const std::string& bytes) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CAPTURE(size);
    CHECK(image_refusal(bytes.substr(0, size)).find("a.image") != std::string::npos);
  }
}

void check_damage(const std::string& bytes) {
  Random random(1);
  for (int round = 0; round < 300; ++round) {
    std::string damaged = bytes;
    for (int i = 0; i < 3; ++i) {
      damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
    }
    const std::string message = image_refusal(damaged);
    CHECK((message.empty() || message.find("a.image") != std::string::npos));
  }
}

double gray(double red, double green, double blue) {
  return 0.299 * red + 0.587 * green + 0.114 * blue;
}

}  // namespace transformesh::test
