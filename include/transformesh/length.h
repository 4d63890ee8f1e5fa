/// A length as users write it: `0.02` in input coordinates, `1%` of the bounding-box diagonal,
/// `0.7x` of the reference edge (the mean edge when an evolution begins).
#pragma once

#include <string>
#include <string_view>

#include "transformesh/errors.h"

namespace transformesh {

struct Length {
  enum class Unit { absolute, diagonal, reference_edge };

  double value = 0;  ///< multiple of the unit: 1% is 0.01
  Unit unit = Unit::absolute;

  /// Returns the length in input units. Ignores arguments that the unit does not need.
  double resolve(double diagonal, double reference_edge) const;
  /// Returns text that parse_length() reads as the same length.
  std::string text() const;
};

/// Parses a finite number with an optional `%` or `x`. Throws UsageError, naming the text, if it is
/// anything else. Accepts negative numbers. Independent of the locale.
Length parse_length(std::string_view text);

}  // namespace transformesh
