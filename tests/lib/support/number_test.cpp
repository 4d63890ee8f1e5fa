#include "support/number.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("a number is the whole text or none") {
  CHECK(number_in<double>("-0.5e3") == -500);
  CHECK(number_in<long>("12") == 12);
  CHECK(number_in<unsigned>("ff", 16) == 255U);
  for (const char* text : {"", " 1", "1 ", "1x", "+1", "x"}) CHECK_FALSE(number_in<double>(text));
  CHECK_FALSE(number_in<long>("1.5"));
  CHECK_FALSE(number_in<double>("1e999"));
}

TEST_CASE("numbers have so many digits or decimals, or as few as read back the same") {
  CHECK(significant(1234567, 6) == "1.23457e+06");
  CHECK(significant(0.1, 3) == "0.1");
  CHECK(fixed(2, 4) == "2.0000");
  CHECK(fixed(-0.00005, 3) == "-0.000");
  CHECK(shortest_text(0.1) == "0.1");
  CHECK(fixed(1e300, 2).size() == 304);
  CHECK(read_back(significant(1.0 / 3, 9)) == 0.333333333);
}
