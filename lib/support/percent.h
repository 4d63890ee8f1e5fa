/// Shares in messages.
#pragma once

#include <string>

#include "support/number.h"

namespace transformesh {

/// Formats a share as percent without the sign: "0.25", "3.4", "54", "100". Two digits, or all
/// digits before the point.
inline std::string percent_text(double share) {
  const double percent = 100 * share;
  constexpr double two_digits = 9.95;  // from here on, two significant digits have no decimal
  return percent < two_digits ? significant(percent, 2) : fixed(percent, 0);
}

}  // namespace transformesh
