#include <doctest/doctest.h>

#include "helpers/encoded_images.h"
#include "views/images/image_file.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("PNM as text and binary, of 8 and 16 bits, with comments") {
  const auto intensity = [](const std::string& bytes, int x, int y) {
    return static_cast<double>(decode_photograph(bytes, "a.pnm").at(x, y));
  };
  CHECK(intensity("P2\n# text\n2 2 # more\n15\n0 5\n 10 15\n", 1, 0) == doctest::Approx(85));
  CHECK(intensity("P3 1 1 255 10 20 30", 0, 0) == doctest::Approx(gray(10, 20, 30)));
  CHECK(intensity(std::string("P5 2 1 255\n") + '\n' + '\x20', 0, 0) == 10);
  CHECK(intensity(std::string("P5 1 1 65535\n\x12\x34", 15), 0, 0) ==
        doctest::Approx(0x1234 / 257.0));
  CHECK(intensity(std::string("P6 1 1 255 \x01\x02\x03"), 0, 0) == doctest::Approx(gray(1, 2, 3)));
  CHECK(intensity(std::string("P5 1 2 255 \x01\x02"), 0, 1) == 2);
}

TEST_CASE("a PNM that is cut short is refused, and damage does no harm") {
  const Rows rows = noise(19 * 13 * 3);
  const std::string bytes = "P6 19 13 255\n" + std::string(rows.begin(), rows.end());
  check_beginnings(bytes);
  check_damage(bytes);
  check_beginnings("P2 2 2 9 1 2 3 4");
}

TEST_CASE("errors in a PNM are reported") {
  CHECK(image_refusal("P5 0 4 255 ").find("no pixel") != std::string::npos);
  CHECK(image_refusal("P5 100000 100000 255 ").find("too large") != std::string::npos);
  CHECK(image_refusal("P5 3000 3000 255 abc").find("cannot be stored in") != std::string::npos);
  CHECK(image_refusal("P2 1 1 9 10").find("above the maximum") != std::string::npos);
  CHECK(image_refusal("P5 3 1 9 \x01\x09\x0a").find("byte 11") != std::string::npos);
  CHECK(image_refusal("P2 1 1 70000 10").find("65535") != std::string::npos);
  CHECK(image_refusal("P2 1 1 9 -1").find("byte 9") != std::string::npos);
  CHECK(image_refusal("P2 1 x 9 1").find("height") != std::string::npos);
}
