/// The colors of rows of text, whose number of channels and type show only at the end of the file.
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <vector>

#include "transformesh/columns.h"

namespace transformesh {

class ColorRows {
 public:
  using Color = std::array<double, 4>;
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  static constexpr Color no_color{missing, missing, missing, missing};

  /// Rows in growing order; those left out have no color. A color is bad and becomes zeros if one
  /// of its first `channels` values is NaN.
  void set(std::size_t row, const Color& color, std::size_t channels);
  /// Shows a number as it is written: a point or an exponent makes all colors floating point.
  void see_word(std::string_view word);

  /// Adds red green blue (alpha), or color_index where rows have one number only. Integers become
  /// uchar (an index int) where they fit, then int, else double. Rows without color get zeros,
  /// without alpha are opaque.
  void add_columns(std::size_t rows, Columns& columns);
  std::size_t missing_rows() const;
  std::size_t bad_rows() const { return bad_rows_; }

 private:
  bool is_any(std::size_t channel) const;
  Scalar type_of_values() const;
  void add_column(const char* name, Scalar type, std::size_t channel, double absent,
                  Columns& columns) const;

  std::vector<Color> colors_;
  bool is_integer_ = true;
  std::size_t bad_rows_ = 0;
};

}  // namespace transformesh
