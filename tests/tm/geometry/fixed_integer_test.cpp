/// Integers of a fixed length, and coordinates as such, against Boost's integers and rationals.
#include "tm/geometry/fixed_integer.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "helpers/random.h"
#include "helpers/rational.h"

namespace transformesh {
namespace {

using Integer = boost::multiprecision::cpp_int;
using test::Rational;

template <std::size_t length>
Integer value(const FixedInteger<length>& number) {
  Integer sum = 0;
  for (std::size_t i = length; i-- > 0;) sum = (sum << 64U) + number.words[i];
  return number.is_negative() ? sum - (Integer(1) << (64 * length)) : sum;
}

int sign_of(const Integer& number) { return number > 0 ? 1 : number < 0 ? -1 : 0; }

/// Of up to 120 bits, now and then one with long runs of zeros or ones.
FixedInteger<2> some_integer(test::Random& random) {
  const auto word = [&]() -> std::uint64_t {
    switch (random.below(4)) {
      case 0:
        return 0;
      case 1:
        return ~std::uint64_t{0};
      default:
        return random.below(~std::uint64_t{0});
    }
  };
  FixedInteger<2> number;
  const auto high = static_cast<std::int64_t>(word()) >> random.below(60) >> 6U;
  number.words = {word(), static_cast<std::uint64_t>(high)};
  return number;
}

}  // namespace

TEST_CASE("sums, differences and products are those of integers without bounds") {
  test::Random random(11);
  for (int round = 0; round < 20000; ++round) {
    const auto a = some_integer(random), b = some_integer(random), c = some_integer(random);
    REQUIRE(value(a + b) == value(a) + value(b));
    REQUIRE(value(a - b) == value(a) - value(b));
    REQUIRE(value(a * b) == value(a) * value(b));
    const auto minor = a * b - b * c;
    REQUIRE(value(minor * c) == value(minor) * value(c));
    REQUIRE((minor * c).sign() == sign_of(value(minor) * value(c)));
  }
}

TEST_CASE("doubles become multiples of one power of two, or nothing where they are too far apart") {
  test::Random random(12);
  int scaled = 0;
  for (int round = 0; round < 20000; ++round) {
    const int spread = round % 2 == 0 ? 30 : 80;
    const int middle = static_cast<int>(random.below(1800)) - 900;
    std::array<double, 4> numbers{};
    for (double& x : numbers) {
      const int exponent = middle + static_cast<int>(random.below(spread));
      x = random.below(6) == 0 ? 0.0 : std::ldexp(random.uniform(-1, 1), exponent);
    }
    const auto integers = scaled_integers<4>(numbers);
    if (spread == 30) REQUIRE(integers.has_value());
    if (!integers) continue;
    ++scaled;
    // All ratios are kept, and signs.
    for (std::size_t i = 0; i < 4; ++i) {
      const Integer first = value((*integers)[i]), next = value((*integers)[(i + 1) % 4]);
      REQUIRE(Rational(first) * Rational(numbers[(i + 1) % 4]) ==
              Rational(next) * Rational(numbers[i]));
      REQUIRE(sign_of(first) == (numbers[i] > 0) - (numbers[i] < 0));
      REQUIRE(abs(first) < Integer(1) << 122U);
    }
  }
  CHECK(scaled > 15000);
}

TEST_CASE("the smallest and the largest doubles are integers too, but not together") {
  const double tiny = 5e-324, huge = 1.7976931348623157e308;
  CHECK(scaled_integers<2>({tiny, -3 * tiny}).has_value());
  CHECK(value((*scaled_integers<2>({tiny, -3 * tiny}))[1]) == -3);
  CHECK(scaled_integers<2>({huge, -huge}).has_value());
  CHECK(!scaled_integers<2>({huge, tiny}).has_value());
  CHECK(value((*scaled_integers<2>({0.0, -0.0}))[1]) == 0);
  CHECK(value((*scaled_integers<2>({0x1p-500, 0x1p-379}))[1]) == Integer(1) << 121U);
  CHECK(!scaled_integers<2>({0x1p-500, 0x1p-378}).has_value());
}

}  // namespace transformesh
