#include "io/streams/file_list.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace transformesh;

TEST_CASE("runs of digits compare as numbers") {
  std::vector<std::string> names{"view10", "view9", "view09", "view", "a2b10", "a2b9", "view1a"};
  std::sort(names.begin(), names.end(), is_natural_less);
  const std::vector<std::string> expected{"a2b9",   "a2b10", "view",  "view1a",
                                          "view09", "view9", "view10"};
  CHECK(names == expected);
}

TEST_CASE("the natural order is a strict weak order") {
  std::vector<std::string> names{"", "0", "00", "1", "01", "a", "a0", "a00b", "a0b1", "a0b01", "9"};
  for (const auto& a : names) {
    for (const auto& b : names) {
      CHECK(is_natural_less(a, b) + is_natural_less(b, a) == (a == b ? 0 : 1));
      for (const auto& c : names) {
        if (is_natural_less(a, b) && is_natural_less(b, c)) CHECK(is_natural_less(a, c));
      }
    }
  }
}

TEST_CASE("a stem is a name without folder and extension") {
  CHECK(stem_of("data/dinoR0000.png") == "dinoR0000");
  CHECK(stem_of("a.b.jpg") == "a.b");
  CHECK(stem_of("view.001") == "view.001");
  CHECK(stem_of("cam/view.001.P") == "view.001");
  CHECK(stem_of("plain") == "plain");
}
