#include "helpers/exact_function.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace transformesh::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr long smallest_exponent = -1073;  ///< exponent of the smallest double, as MPFR counts

class BigNumber {
 public:
  explicit BigNumber(double value = 0) {
    mpfr_init2(number_, 200);
    mpfr_set_d(number_, value, MPFR_RNDN);
  }
  BigNumber(const BigNumber&) = delete;
  BigNumber& operator=(const BigNumber&) = delete;
  ~BigNumber() { mpfr_clear(number_); }

  mpfr_ptr get() { return number_; }
  mpfr_srcptr get() const { return number_; }

 private:
  mpfr_t number_;
};

double units_off(double result, const BigNumber& exact) {
  if (mpfr_regular_p(exact.get()) == 0)
    return is_same(std::abs(result), std::abs(mpfr_get_d(exact.get(), MPFR_RNDN))) ? 0 : infinity;
  if (std::isnan(result)) return infinity;
  if (std::isinf(result) && result == mpfr_get_d(exact.get(), MPFR_RNDN)) return 0;
  BigNumber difference(std::isinf(result) ? std::copysign(1, result) : result);
  if (std::isinf(result)) mpfr_mul_2si(difference.get(), difference.get(), 1024, MPFR_RNDN);
  mpfr_sub(difference.get(), difference.get(), exact.get(), MPFR_RNDA);
  const long unit = std::max(mpfr_get_exp(exact.get()) - 53, smallest_exponent - 1);
  mpfr_mul_2si(difference.get(), difference.get(), -unit, MPFR_RNDN);
  return std::abs(mpfr_get_d(difference.get(), MPFR_RNDA));
}

}  // namespace

double units_off(double result, ExactFunction function, double x) {
  const BigNumber argument(x);
  BigNumber exact;
  function(exact.get(), argument.get(), MPFR_RNDN);
  return units_off(result, exact);
}

double units_off(double result, ExactFunctionOfTwo function, double x, double y) {
  const BigNumber first(x);
  const BigNumber second(y);
  BigNumber exact;
  function(exact.get(), first.get(), second.get(), MPFR_RNDN);
  return units_off(result, exact);
}

double any_number(Random& random, int low, int high) {
  const auto range = static_cast<std::uint64_t>(high - low + 1);
  const double size = std::ldexp(random.uniform(1, 2), low + static_cast<int>(random.below(range)));
  return random.below(2) == 0 ? size : -size;
}

std::vector<double> neighborhood(double x, int count) {
  for (int i = 0; i < count; ++i) x = std::nextafter(x, -infinity);
  std::vector<double> numbers;
  for (int i = 0; i <= 2 * count; ++i) {
    numbers.push_back(x);
    x = std::nextafter(x, infinity);
  }
  return numbers;
}

bool is_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

}  // namespace transformesh::test
