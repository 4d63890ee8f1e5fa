#include "picture/parse_picture_options.h"

#include <doctest/doctest.h>

#include "support/error.h"

using namespace transformesh;

TEST_CASE("sizes and angles are read") {
  CHECK(parse_size("800x600") == std::pair(800, 600));
  CHECK(parse_size("1x1") == std::pair(1, 1));
  CHECK(parse_orbit("30,20") == std::pair(30.0, 20.0));
  CHECK(parse_orbit("-12.5,1e2") == std::pair(-12.5, 100.0));
  for (const char* text :
       {"", "800", "800x", "x600", "800x600x3", "0x600", "800x-1", "8 x6", "axb", "99999999999x1"})
    CHECK_THROWS_AS(parse_size(text), UsageError);
  for (const char* text : {"", "30", "30,", ",20", "30,20,10", "30;20", "nan,0", "0,inf"})
    CHECK_THROWS_AS(parse_orbit(text), UsageError);
}

TEST_CASE("colors are read as sRGB") {
  CHECK(parse_color("#ff0080") == color_of_srgb(1, 0, 128 / 255.0));
  CHECK(parse_color("#f08") == color_of_srgb(1, 0, 8 / 15.0));
  CHECK(parse_color("white") == Color(1, 1, 1));
  CHECK(parse_color("black") == Color(0, 0, 0));
  CHECK(parse_color("grey") == parse_color("gray"));
  for (const char* text :
       {"", "#", "#12", "#12345", "#gggggg", "#-12345", "ff0080", "mauve", "# 12345"})
    CHECK_THROWS_AS(parse_color(text), UsageError);
  CHECK_THROWS_WITH(parse_color("mauve"),
                    "'mauve' is not a color: write it as #rrggbb, or white, black or gray");
}

TEST_CASE("backgrounds are one color, two or none") {
  CHECK(parse_background("#f7f7f7,#d6d9de").top == Background{}.top);
  CHECK(parse_background("#f7f7f7,#d6d9de").bottom == Background{}.bottom);
  CHECK(parse_background("transparent").is_transparent);
  const Background plain = parse_background("#102030");
  CHECK(plain.top == parse_color("#102030"));
  CHECK(plain.bottom == plain.top);
  CHECK_FALSE(plain.is_transparent);
  const Background two = parse_background("white,black");
  CHECK(two.at(0, 1) == Color(0.5F, 0.5F, 0.5F));
  CHECK(two.at(0, 2) == Color(0.75F, 0.75F, 0.75F));
  CHECK_THROWS_AS(parse_background("white,"), UsageError);
  CHECK_THROWS_AS(parse_background("white,black,white"), UsageError);
}
