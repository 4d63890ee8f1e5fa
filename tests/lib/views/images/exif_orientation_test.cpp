#include "views/images/exif_orientation.h"

#include <doctest/doctest.h>

#include <string>

using namespace transformesh;

namespace {

/// A TIFF directory with a width and an orientation, in either byte order.
std::string tiff(bool is_little, int orientation) {
  const auto number = [&](unsigned value, int size) {
    std::string bytes;
    for (int i = 0; i < size; ++i)
      bytes += static_cast<char>(value >> (8 * (is_little ? i : size - 1 - i)) & 255U);
    return bytes;
  };
  const auto entry = [&](unsigned tag, unsigned value) {
    return number(tag, 2) + number(3, 2) + number(1, 4) + number(value, 2) + number(0, 2);
  };
  return (is_little ? "II" : "MM") + number(42, 2) + number(8, 4) + number(2, 2) +
         entry(0x100, 640) + entry(0x112, static_cast<unsigned>(orientation)) + number(0, 4);
}

std::string segment(char marker, const std::string& data) {
  const std::size_t size = data.size() + 2;
  return std::string("\xff") + marker + static_cast<char>(size / 256) +
         static_cast<char>(size % 256) + data;
}

std::string jpeg(const std::string& exif) {
  return "\xff\xd8" + segment('\xe0', "JFIF") + segment('\xe1', std::string("Exif\0\0", 6) + exif) +
         segment('\xda', "pixels");
}

}  // namespace

TEST_CASE("the orientation of JPEG and TIFF is found in either byte order") {
  for (const bool is_little : {false, true}) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
      CHECK(exif_orientation(tiff(is_little, orientation)) == orientation);
      CHECK(exif_orientation(jpeg(tiff(is_little, orientation))) == orientation);
    }
    CHECK(exif_orientation(tiff(is_little, 9)) == 1);
  }
}

TEST_CASE("files without orientation, and damaged ones, have orientation 1 or what they state") {
  CHECK(exif_orientation("") == 1);
  CHECK(exif_orientation("P5 1 1 255 x") == 1);
  CHECK(exif_orientation("\xff\xd8\xff\xe1") == 1);
  const std::string whole = jpeg(tiff(true, 6));
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const int orientation = exif_orientation(std::string_view(whole).substr(0, size));
    CHECK((orientation == 1 || orientation == 6));
  }
}
