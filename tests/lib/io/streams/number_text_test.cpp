#include "io/streams/number_text.h"

#include <doctest/doctest.h>

#include <bit>
#include <cstdlib>
#include <random>
#include <string>

#include "io/streams/text_buffer.h"

using namespace transformesh;

namespace {

template <class T>
Parsed parse(const std::string& text, T& value, std::size_t& used) {
  const char* first = text.data();
  const Parsed parsed = parse_number(first, text.data() + text.size(), value);
  used = static_cast<std::size_t>(first - text.data());
  return parsed;
}

}  // namespace

TEST_CASE("number text: reads what strtod reads") {
  for (const std::string text : {"0", "-0", "1", "+1", "-1.5", ".5", "5.", "1e5", "1E+5", "-2.5e-3",
                                 "123456789012345678901234567890", "4.9e-324",
                                 "1.7976931348623157e308", "0.1", "0e999999999"}) {
    double value = 7;
    std::size_t used = 0;
    CHECK(parse(text, value, used) == Parsed::ok);
    CHECK(used == text.size());
    CHECK(std::bit_cast<std::uint64_t>(value) ==
          std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)));
  }
}

TEST_CASE("number text: too small numbers are zero, too large ones are refused") {
  double value = 7;
  std::size_t used = 0;
  const std::string zeros(400, '0');
  for (const std::string text : {"1e-400", "-1e-400", "2e-324", "1e-99999999999999999999",
                                 "1e-9223372036854775808", "1e-2147483648"}) {
    CHECK(parse(text, value, used) == Parsed::ok);
    CHECK(value == 0);
  }
  CHECK(parse("0." + zeros + "1", value, used) == Parsed::ok);
  for (const std::string text :
       {"1e400", "-1e400", "1e99999999999999999999", "10e9223372036854775807", "10e2147483647"}) {
    CHECK(parse(text, value, used) == Parsed::out_of_range);
  }
  CHECK(parse("1" + zeros, value, used) == Parsed::out_of_range);
  CHECK(parse("0." + zeros + "1e900", value, used) == Parsed::out_of_range);
  CHECK(parse("1" + zeros + "e-900", value, used) == Parsed::ok);
  float single = 7;
  CHECK(parse("1e-46", single, used) == Parsed::ok);
  CHECK(single == 0);
  CHECK(parse("1e39", single, used) == Parsed::out_of_range);
}

TEST_CASE("number text: other text is malformed") {
  double value = 7;
  std::size_t used = 0;
  for (const std::string text : {"", "+", "-", "x", "+-1", "e5", ","}) {
    CHECK(parse(text, value, used) == Parsed::malformed);
  }
  std::uint64_t count = 7;
  CHECK(parse("-3", count, used) == Parsed::malformed);
  CHECK(parse("18446744073709551616", count, used) == Parsed::out_of_range);
}

TEST_CASE("number text: every double and float comes back bit for bit") {
  std::mt19937_64 random(1);
  TextBuffer text;
  std::vector<double> doubles;
  std::vector<float> floats;
  while (doubles.size() < 2000) {
    const auto value = std::bit_cast<double>(random());
    const auto single = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value) || !std::isfinite(single)) continue;
    doubles.push_back(value);
    floats.push_back(single);
    text.add_number(value);
    text.add(' ');
    text.add_number(single);
    text.add(' ');
  }
  const std::string written = text.take();
  const char* place = written.c_str();
  for (std::size_t i = 0; i < doubles.size(); ++i) {
    char* end = nullptr;
    CHECK(std::strtod(place, &end) == doubles[i]);
    CHECK(std::strtof(end, &end) == floats[i]);
    place = end;
  }
}

TEST_CASE("number text: decimals always look like decimals") {
  for (const auto& [value, expected] : std::vector<std::pair<double, std::string>>{
           {1, "1.0"}, {0.5, "0.5"}, {1e300, "1e+300"}, {123456, "123456.0"}, {-0.0, "-0.0"}}) {
    TextBuffer text;
    text.add_decimal(value);
    CHECK(text.take() == expected);
  }
}
