/// A length as users write it: `0.02` in input coordinates, `1%` of the bounding-box diagonal,
/// `0.7x` of the reference edge (the mean edge when an evolution begins).
#pragma once

#include <string>
#include <string_view>

#include "transformesh/errors.h"

namespace transformesh {

struct Length {
  enum class Unit { absolute, diagonal, reference_edge };

  double value = 0;  ///< as a factor: 1% is 0.01
  Unit unit = Unit::absolute;

  /// Input units, given both bases. A base that the unit does not use may be anything.
  double resolve(double diagonal, double reference_edge) const;
  /// The spelling that parse_length reads back.
  std::string text() const;
};

/// Reads a finite number with an optional `%` or `x`. Throws UsageError naming the text otherwise.
/// The sign is the caller's to judge. Independent of the locale.
Length parse_length(std::string_view text);

}  // namespace transformesh
