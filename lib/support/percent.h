/// Formats fractions as percentages in messages.
#pragma once

#include <string>

#include "support/number.h"

namespace transformesh {

/// Returns a fraction as a percentage without the percent sign: "0.25", "3.4", "54" or "100".
/// Percentages below 9.95 have two significant digits; larger ones are rounded to integers.
inline std::string percent_text(double share) {
  const double percent = 100 * share;
  constexpr double two_digits = 9.95;  // from here on, two significant digits have no decimal
  return percent < two_digits ? significant(percent, 2) : fixed(percent, 0);
}

}  // namespace transformesh
