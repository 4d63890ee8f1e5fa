#include "transformesh/length.h"

#include <charconv>
#include <cmath>

#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {

double Length::resolve(double diagonal, double reference_edge) const {
  switch (unit) {
    case Unit::diagonal:
      return value * diagonal;
    case Unit::reference_edge:
      return value * reference_edge;
    default:
      return value;
  }
}

std::string Length::text() const {
  switch (unit) {
    case Unit::diagonal:
      return shortest_text(value * 100) + '%';
    case Unit::reference_edge:
      return shortest_text(value) + 'x';
    default:
      return shortest_text(value);
  }
}

Length parse_length(std::string_view text) {
  Length length;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, length.value);
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  if (error != std::errc() || !std::isfinite(length.value) ||
      !(unit.empty() || unit == "%" || unit == "x")) {
    throw UsageError("'" + std::string(text) +
                     "' is not a length: write 0.02 (input units), 1% (of the diagonal) or 0.7x "
                     "(of the reference edge)");
  }
  if (unit == "%") {
    length.value /= 100;
    length.unit = Length::Unit::diagonal;
  } else if (unit == "x") {
    length.unit = Length::Unit::reference_edge;
  }
  return length;
}

}  // namespace transformesh
