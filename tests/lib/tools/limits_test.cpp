#include "frame/limits.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::tool;

TEST_CASE("sizes are bytes, or have a unit") {
  CHECK(parse_size("1") == 1);
  CHECK(parse_size("2000000000") == 2000000000);
  CHECK(parse_size("500M") == 500ULL << 20);
  CHECK(parse_size("1.5G") == 3ULL << 29);
  CHECK(parse_size("2KiB") == 2048);
  CHECK(parse_size("2KB") == 2048);
  CHECK(parse_size("1T") == 1ULL << 40);
  for (const char* text :
       {"", "M", "0", "-1", "1X", "1MM", "1 M", "nan", "inf", "1e30", "B1", "0.5"})
    CHECK_THROWS_AS(parse_size(text), UsageError);
}

TEST_CASE("sizes are shown with three digits") {
  CHECK(size_text(5) == "5 bytes");
  CHECK(size_text(1 << 20) == "1M");
  CHECK(size_text(3ULL << 29) == "1.5G");
  CHECK(size_text(1023ULL << 10) == "1023K");
  CHECK(size_text(25117000000) == "23.4G");
}

TEST_CASE("the size of the memory is known") { CHECK(available_memory() > 1 << 20); }
