#include "support/base64.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("base64 as RFC 4648 has it") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64(std::string("\xff\xfe\x00\xfb", 4)) == "//4A+w==");
}

TEST_CASE("base64 back to bytes, with blanks and padding inside") {
  CHECK(bytes_of_base64("Zm9vYmFy") == "foobar");
  CHECK(bytes_of_base64("Zm9v\n Y\tg==") == "foob");
  CHECK(bytes_of_base64("Zg==Zm8=") == "ffo");
  CHECK(bytes_of_base64("//4A+w==") == std::string("\xff\xfe\x00\xfb", 4));
  CHECK_FALSE(bytes_of_base64("Zm9v-").has_value());
}
