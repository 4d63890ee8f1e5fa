#include "support/numbered_selection.h"

#include <doctest/doctest.h>

#include "transformesh/control.h"

using namespace transformesh;

TEST_CASE("selected indices are numbered in their order, for any number of threads") {
  for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 8192U, 100'001U}) {
    const auto is_selected = [](std::size_t i) { return i * i % 7 == 2; };
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < count; ++i)
      if (is_selected(i)) expected.push_back(i);
    for (const int threads : {1, 3}) {
      CAPTURE(count);
      CAPTURE(threads);
      const ThreadLimit limit(threads);
      const NumberedSelection selection(count, is_selected);
      REQUIRE(selection.size() == expected.size());
      std::vector<std::size_t> found(expected.size());
      selection.visit([&](std::size_t i, std::size_t number) { found.at(number) = i; });
      CHECK(found == expected);
      const auto list = selection.list();
      CHECK(std::equal(list.begin(), list.end(), expected.begin(), expected.end()));
    }
  }
}
