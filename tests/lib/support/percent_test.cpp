#include "support/percent.h"

#include <doctest/doctest.h>

using namespace transformesh;

TEST_CASE("shares have two digits, or all digits before the point") {
  CHECK(percent_text(0.00254) == "0.25");
  CHECK(percent_text(0.034) == "3.4");
  CHECK(percent_text(0.0994) == "9.9");
  CHECK(percent_text(0.0996) == "10");
  CHECK(percent_text(0.5449) == "54");
  CHECK(percent_text(0.9999) == "100");
  CHECK(percent_text(1.5) == "150");
}
