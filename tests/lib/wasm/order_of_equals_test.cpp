#include "../wasm/order_of_equals.h"

#include <doctest/doctest.h>

#include <random>
#include <vector>

namespace {

struct Element {
  unsigned key;
  unsigned place;  ///< identifies equal elements
  bool operator==(const Element&) const = default;
};

/// `count` elements with keys below `keys`, sorted by key if `is_sorted`.
std::vector<Element> elements(unsigned count, unsigned keys, bool is_sorted, std::mt19937& random) {
  std::vector<Element> result;
  for (unsigned i = 0; i < count; ++i)
    result.push_back({is_sorted ? i * keys / count : static_cast<unsigned>(random() % keys), i});
  return result;
}

}  // namespace

// The order must be that of the standard library of the native build.
TEST_CASE("selection for WebAssembly leaves equal elements where libstdc++ leaves them") {
  std::mt19937 random(1);
  const auto is_less = [](const Element& a, const Element& b) { return a.key < b.key; };
  for (unsigned round = 0; round < 20000; ++round) {
    const unsigned count = 1 + static_cast<unsigned>(random() % 200);
    const unsigned keys = 1 + static_cast<unsigned>(random() % 20);
    std::vector<Element> native = elements(count, keys, round % 4 == 0, random);
    std::vector<Element> other = native;
    const auto nth = static_cast<std::ptrdiff_t>(random() % (count + 1));
    std::nth_element(native.begin(), native.begin() + nth, native.end(), is_less);
    transformesh::order::select(other.begin(), other.begin() + nth, other.end(), is_less);
    REQUIRE(other == native);
  }
}
