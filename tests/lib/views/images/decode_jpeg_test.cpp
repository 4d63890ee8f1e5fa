#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "helpers/encoded_images.h"
#include "views/images/image_file.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// The upper half has one color, the lower half another one.
Rows halves(int width, int height, const Rows& upper, const Rows& lower) {
  Rows rows;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Rows& color = 2 * y < height ? upper : lower;
      rows.insert(rows.end(), color.begin(), color.end());
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("JPEG of gray and color, of one scan, several, and with restarts") {
  const std::array<JpegKind, 3> kinds{JpegKind{}, JpegKind{3, true, 0}, JpegKind{3, false, 2}};
  for (const JpegKind& kind : kinds) {
    const Rows rows = halves(40, 32, {200, 30, 90}, {10, 220, 60});
    const GrayImage image = decode_photograph(jpeg_of(kind, 40, 32, rows), "a.jpg");
    REQUIRE(image.width == 40);
    REQUIRE(image.height == 32);
    REQUIRE(image.pixels.size() == 40 * 32);
    CHECK(std::abs(static_cast<double>(image.at(5, 3)) - gray(200, 30, 90)) < 2);
    CHECK(std::abs(static_cast<double>(image.at(39, 31)) - gray(10, 220, 60)) < 2);
  }
  const Rows intensities = halves(9, 16, {40}, {230});
  const GrayImage image = decode_photograph(jpeg_of({1}, 9, 16, intensities), "a.jpg");
  CHECK(std::abs(image.at(8, 7) - 40) < 2);
  CHECK(std::abs(image.at(0, 8) - 230) < 2);
}

TEST_CASE("a CMYK JPEG is decoded to the light that the inks leave") {
  // Inverted inks: cyan and black together leave 200 * 128 / 255 of red.
  const Rows rows = halves(16, 16, {200, 255, 0, 128}, {0, 0, 255, 255});
  const GrayImage image = decode_photograph(jpeg_of({4}, 16, 16, rows), "a.jpg");
  CHECK(std::abs(static_cast<double>(image.at(3, 3)) - gray(100.4, 128, 0)) < 2);
  CHECK(std::abs(static_cast<double>(image.at(3, 12)) - gray(0, 0, 255)) < 2);
}

TEST_CASE("a JPEG is decoded as recorded, and its orientation tag ignored") {
  std::string bytes = jpeg_of({1}, 16, 8, halves(16, 8, {0}, {255}));
  const std::string turned(
      "\xff\xe1\0\x22"
      "Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
      36);
  bytes.insert(2, turned);
  const GrayImage image = decode_photograph(bytes, "a.jpg");
  CHECK(image.width == 16);
  CHECK(image.height == 8);
}

TEST_CASE("a JPEG that is cut short is refused, and damage does no harm") {
  for (const bool is_progressive : {false, true}) {
    CAPTURE(is_progressive);
    const std::string bytes = jpeg_of({3, is_progressive, 0}, 19, 13, noise(19 * 13 * 3));
    check_beginnings(bytes);
    check_damage(bytes);
    CHECK(image_refusal(bytes.substr(0, bytes.size() - 40)) ==
          "not a complete JPEG image: the file ends too early (a.image)");
  }
}

TEST_CASE("a JPEG with a complete thumbnail in it is still incomplete") {
  const std::string thumbnail = jpeg_of({1}, 8, 8, noise(64));
  std::string bytes = jpeg_of({1}, 33, 21, noise(33 * 21));
  const std::size_t size = thumbnail.size() + 2;
  bytes.insert(2, "\xff\xe1" +
                      std::string{static_cast<char>(size / 256), static_cast<char>(size % 256)} +
                      thumbnail);
  CHECK(decode_photograph(bytes, "a.jpg").width == 33);
  CHECK(image_refusal(bytes.substr(0, bytes.size() - 40)).find("ends too early") !=
        std::string::npos);
}

TEST_CASE("damage that libjpeg would fill by a guess is refused with its row") {
  std::string bytes = jpeg_of({1, false, 1}, 8, 64, noise(8 * 64));
  const std::size_t restart = bytes.find("\xff\xd3");
  REQUIRE(restart != std::string::npos);
  bytes[restart + 1] = '\xd6';
  CHECK(image_refusal(bytes) ==
        "not a complete JPEG image: Corrupt JPEG data: found marker 0xd6 instead of RST3, in row "
        "33 (a.image)");
}

TEST_CASE("a JPEG that claims what its bytes cannot hold, or scans without end, is refused") {
  std::string bytes = jpeg_of({1, true, 0}, 8, 8, noise(64));
  const std::size_t frame = bytes.find("\xff\xc2");
  REQUIRE(frame != std::string::npos);
  std::string claim = bytes;
  claim.replace(frame + 5, 4, "\x4e\x20\x4e\x20");
  CHECK(image_refusal(claim).find("20000 x 20000 pixels cannot be stored in") != std::string::npos);
  claim.replace(frame + 5, 4, "\xff\xdc\xff\xdc");
  CHECK(image_refusal(claim).find("too large") != std::string::npos);
  claim.replace(frame + 5, 4, std::string(4, '\0'));
  CHECK(image_refusal(claim) != "");

  const std::size_t scan = bytes.find("\xff\xda");
  const std::size_t end = bytes.find("\xff\xc4", scan);
  REQUIRE(end != std::string::npos);
  const std::string again = bytes.substr(scan, end - scan);
  for (int i = 0; i < 50; ++i) bytes.insert(scan, again);
  CHECK(image_refusal(bytes) == "");
  for (int i = 0; i < 50; ++i) bytes.insert(scan, again);
  CHECK(image_refusal(bytes).find("more than 100 scans") != std::string::npos);
}
