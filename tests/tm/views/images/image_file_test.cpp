#include "tm/views/images/image_file.h"

#include <doctest/doctest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "helpers/random.h"
#include "tm/support/error.h"

using namespace transformesh;

namespace {

std::string refusal(const std::string& bytes) {
  try {
    decode_photograph(bytes, "a.image");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Every beginning of the file must be refused, and name the file.
void check_truncations(const std::string& bytes, std::size_t step) {
  for (std::size_t size = 0; size < bytes.size(); size += step) {
    CAPTURE(size);
    CHECK(refusal(bytes.substr(0, size)).find("a.image") != std::string::npos);
  }
}

// Bytes changed at random: an image or a refusal, and no crash.
void check_damage(const std::string& bytes) {
  test::Random random(1);
  for (int round = 0; round < 300; ++round) {
    std::string damaged = bytes;
    for (int i = 0; i < 3; ++i) {
      damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
    }
    const std::string message = refusal(damaged);
    CHECK((message.empty() || message.find("a.image") != std::string::npos));
  }
}

struct PngKind {
  int color_type;
  int depth;
  bool is_interlaced;
};

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(data), size);
}

// Rows as PNG packs them.
std::string png_of(const PngKind& kind, int width, int height, std::vector<png_byte> rows) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, nullptr);
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

double grey(double red, double green, double blue) {
  return 0.299 * red + 0.587 * green + 0.114 * blue;
}

cv::Mat noise(int width, int height, int type) {
  cv::Mat image(height, width, type);
  test::Random random(2);
  for (int y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < image.cols * image.elemSize(); ++x) {
      image.ptr(y)[x] = static_cast<unsigned char>(random.below(256));
    }
  }
  return image;
}

std::string encoded(const cv::Mat& image, const std::string& extension) {
  std::vector<unsigned char> bytes;
  REQUIRE(cv::imencode(extension, image, bytes));
  return {bytes.begin(), bytes.end()};
}

// The largest difference to what OpenCV decodes, whose colours are blue, green, red.
double difference(const GrayImage& image, const std::string& bytes) {
  const std::vector<unsigned char> copy(bytes.begin(), bytes.end());
  const cv::Mat expected = cv::imdecode(copy, cv::IMREAD_COLOR);
  REQUIRE(expected.cols == image.width);
  REQUIRE(expected.rows == image.height);
  double largest = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto& pixel = expected.at<cv::Vec3b>(y, x);
      const double level = grey(pixel[2], pixel[1], pixel[0]);
      largest = std::max(largest, std::abs(level - static_cast<double>(image.at(x, y))));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("PNG of every colour type, depth and order of rows") {
  constexpr int width = 3;
  for (const bool is_interlaced : {false, true}) {
    CAPTURE(is_interlaced);
    const auto level = [&](int color_type, int depth, const std::vector<png_byte>& row, int x) {
      std::vector<png_byte> rows = row;
      rows.insert(rows.end(), row.begin(), row.end());
      const std::string bytes = png_of({color_type, depth, is_interlaced}, width, 2, rows);
      const GrayImage image = decode_photograph(bytes, "a.png");
      REQUIRE(image.width == width);
      REQUIRE(image.height == 2);
      CHECK(image.at(x, 0) == image.at(x, 1));
      return static_cast<double>(image.at(x, 1));
    };
    CHECK(level(PNG_COLOR_TYPE_GRAY, 1, {0b01000000}, 1) == 255);
    CHECK(level(PNG_COLOR_TYPE_GRAY, 2, {0b00011000}, 2) == 170);
    CHECK(level(PNG_COLOR_TYPE_GRAY, 4, {0x0f, 0x30}, 2) == 51);
    CHECK(level(PNG_COLOR_TYPE_GRAY, 8, {1, 2, 77}, 2) == 77);
    CHECK(level(PNG_COLOR_TYPE_GRAY, 16, {0, 0, 0x12, 0x34, 0, 0}, 1) ==
          doctest::Approx(0x1234 / 257.0).epsilon(1e-7));
    CHECK(level(PNG_COLOR_TYPE_PALETTE, 1, {0b01000000}, 1) ==
          doctest::Approx(grey(200, 100, 50)).epsilon(1e-7));
    CHECK(level(PNG_COLOR_TYPE_RGB, 8, {0, 0, 0, 1, 2, 3, 9, 8, 7}, 1) ==
          doctest::Approx(grey(1, 2, 3)).epsilon(1e-7));
    CHECK(level(PNG_COLOR_TYPE_RGB_ALPHA, 8, {0, 0, 0, 0, 90, 60, 30, 0, 9, 8, 7, 0}, 1) ==
          doctest::Approx(grey(90, 60, 30)).epsilon(1e-7));
    CHECK(level(PNG_COLOR_TYPE_GRAY_ALPHA, 8, {0, 0, 90, 0, 9, 0}, 1) == 90);
  }
}

TEST_CASE("PNM as text and binary, of 8 and 16 bits, with comments") {
  const auto level = [](const std::string& bytes, int x, int y) {
    return static_cast<double>(decode_photograph(bytes, "a.pnm").at(x, y));
  };
  CHECK(level("P2\n# text\n2 2 # more\n15\n0 5\n 10 15\n", 1, 0) == doctest::Approx(85));
  CHECK(level("P3 1 1 255 10 20 30", 0, 0) == doctest::Approx(grey(10, 20, 30)));
  CHECK(level(std::string("P5 2 1 255\n") + '\n' + '\x20', 0, 0) == 10);
  CHECK(level(std::string("P5 1 1 65535\n\x12\x34", 15), 0, 0) == doctest::Approx(0x1234 / 257.0));
  CHECK(level(std::string("P6 1 1 255 \x01\x02\x03"), 0, 0) == doctest::Approx(grey(1, 2, 3)));
}

TEST_CASE("what OpenCV reads besides equals what it decodes, wherever the module is") {
  const cv::Mat color = noise(37, 21, CV_8UC3);
  for (const char* extension : {".png", ".ppm", ".jpg", ".tiff", ".bmp"}) {
    CAPTURE(extension);
    const std::string bytes = encoded(color, extension);
    CHECK(is_image(bytes));
    CHECK(difference(decode_photograph(bytes, "a.image"), bytes) < 1e-4);
  }
  const std::string deep = encoded(noise(5, 4, CV_16UC1), ".tiff");
  const cv::Mat expected = noise(5, 4, CV_16UC1);
  CHECK(static_cast<double>(decode_photograph(deep, "a.tif").at(3, 2)) ==
        doctest::Approx(expected.at<std::uint16_t>(2, 3) / 257.0));
}

TEST_CASE("every beginning of a file is refused, and damage does no harm") {
  const cv::Mat color = noise(19, 13, CV_8UC3);
  for (const char* extension : {".png", ".ppm", ".jpg"}) {
    CAPTURE(extension);
    const std::string bytes = encoded(color, extension);
    check_truncations(bytes, 1);
    check_damage(bytes);
  }
  const std::string interlaced =
      png_of({PNG_COLOR_TYPE_RGB, 8, true}, 7, 9, std::vector<png_byte>(7 * 9 * 3, 90));
  check_truncations(interlaced, 1);
  check_truncations("P2 2 2 9 1 2 3 4", 1);
  // Decoders of other formats decide, where their libraries tell.
  check_damage(encoded(color, ".tiff"));
  check_damage(encoded(color, ".bmp"));
}

TEST_CASE("a JPEG with a complete thumbnail in it is still incomplete") {
  const std::string thumbnail = encoded(noise(8, 8, CV_8UC1), ".jpg");
  std::string bytes = encoded(noise(33, 21, CV_8UC1), ".jpg");
  const std::size_t size = thumbnail.size() + 2;
  bytes.insert(2, "\xff\xe1" +
                      std::string{static_cast<char>(size / 256), static_cast<char>(size % 256)} +
                      thumbnail);
  CHECK(decode_photograph(bytes, "a.jpg").width == 33);
  CHECK(refusal(bytes.substr(0, bytes.size() - 40)).find("ends too early") != std::string::npos);
}

TEST_CASE("what is no image is refused with its first bytes") {
  CHECK(refusal("").find("empty") != std::string::npos);
  CHECK(refusal("hello, world").find("'hello, world'") != std::string::npos);
  CHECK(refusal("P5 0 4 255 ").find("no pixel") != std::string::npos);
  CHECK(refusal("P5 100000 100000 255 ").find("too large") != std::string::npos);
  CHECK(refusal("P5 3000 3000 255 abc").find("cannot have") != std::string::npos);
  CHECK(refusal("P2 1 1 9 10").find("above the maximum") != std::string::npos);
  CHECK(refusal("P5 3 1 9 \x01\x09\x0a").find("byte 11") != std::string::npos);
  CHECK(refusal("P2 1 1 70000 10").find("65535") != std::string::npos);
  CHECK(refusal("P2 1 1 9 -1").find("byte 9") != std::string::npos);
  CHECK(refusal("P2 1 x 9 1").find("height") != std::string::npos);
}

TEST_CASE("inside a silhouette is what has any sample above zero") {
  const GrayImage deep = decode_silhouette(std::string("P5 2 1 65535\n\0\1\0\0", 17), "a.pgm");
  CHECK(deep.at(0, 0) == 255);
  CHECK(deep.at(1, 0) == 0);
  const GrayImage color = decode_silhouette("P3 2 1 255 0 0 1 0 0 0", "a.ppm");
  CHECK(color.at(0, 0) == 255);
  CHECK(color.at(1, 0) == 0);
}
