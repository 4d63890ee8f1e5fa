/// Integers of fixed length, and coordinates as such integers, compared with Boost's integers and
/// rationals.
#include "geometry/numbers/fixed_integer.h"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "geometry/numbers/word_determinant.h"
#include "helpers/random.h"
#include "helpers/rational.h"

using namespace transformesh;

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

/// Returns an integer of up to 120 bits; some have long runs of zeros or ones.
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
    const CommonScale<4> scale(numbers);
    if (spread == 30) REQUIRE(scale.bits() <= two_word_bits);
    if (scale.bits() > two_word_bits) continue;
    const auto integers = two_word_multiples(scale);
    ++scaled;
    // All ratios and signs are preserved.
    for (std::size_t i = 0; i < 4; ++i) {
      const Integer first = value(integers[i]), next = value(integers[(i + 1) % 4]);
      REQUIRE(Rational(first) * Rational(numbers[(i + 1) % 4]) ==
              Rational(next) * Rational(numbers[i]));
      REQUIRE(sign_of(first) == (numbers[i] > 0) - (numbers[i] < 0));
      REQUIRE(abs(first) < Integer(1) << static_cast<unsigned>(scale.bits()));
      if (scale.bits() <= one_word_bits)
        REQUIRE(first == static_cast<std::int64_t>(scale.multiple<std::uint64_t>(i)));
    }
  }
  CHECK(scaled > 15000);
}

TEST_CASE("the smallest and the largest doubles are integers too, but not together") {
  const double tiny = 5e-324, huge = 1.7976931348623157e308;
  const auto bits = [](double x, double y) { return CommonScale<2>({x, y}).bits(); };
  const auto second = [](double x, double y) {
    return value(two_word_multiples(CommonScale<2>({x, y}))[1]);
  };
  CHECK(bits(tiny, -3 * tiny) == 2);
  CHECK(second(tiny, -3 * tiny) == -3);
  CHECK(bits(huge, -huge) == 53);
  CHECK(bits(huge, tiny) == 2098);
  CHECK(bits(0.0, -0.0) == 0);
  CHECK(second(0.0, -0.0) == 0);
  CHECK(bits(0x1p-500, 0x1p-379) == two_word_bits);
  CHECK(second(0x1p-500, 0x1p-379) == Integer(1) << 121U);
}

TEST_CASE("signs of determinants of words are those of integers without bounds") {
  test::Random random(13);
  constexpr std::int64_t most = (std::int64_t{1} << 61U) - 1;
  const auto word = [&]() -> std::int64_t {
    const auto size = static_cast<std::int64_t>(random.below(most + std::uint64_t{1}));
    const std::array<std::int64_t, 4> sizes{size, size >> random.below(61), most, 0};
    return random.below(2) == 0 ? sizes[random.below(4)] : -sizes[random.below(4)];
  };
  int zeros = 0;
  for (int round = 0; round < 40000; ++round) {
    std::array<std::array<std::int64_t, 3>, 3> rows{};
    for (auto& row : rows)
      for (std::int64_t& x : row) x = word();
    // Every second matrix is singular or nearly singular.
    const std::size_t i = random.below(3);
    if (round % 2 == 0)
      for (std::size_t k = 0; k < 3; ++k)
        rows[i][k] = (rows[(i + 1) % 3][k] - rows[(i + 2) % 3][k]) / 2;
    const auto minor = [&](std::size_t u, std::size_t v) {
      return Integer(rows[1][u]) * rows[2][v] - Integer(rows[1][v]) * rows[2][u];
    };
    const Integer determinant =
        rows[0][0] * minor(1, 2) + rows[0][1] * minor(2, 0) + rows[0][2] * minor(0, 1);
    zeros += determinant == 0 ? 1 : 0;
    REQUIRE(sign_of_word_determinant(rows) == sign_of(determinant));
    REQUIRE(sign_of_word(word_minor(rows[1][0], rows[1][1], rows[2][0], rows[2][1])) ==
            sign_of(minor(0, 1)));
  }
  CHECK(zeros > 5000);
  CHECK(zeros < 35000);
}
