/// Colors read from rows of text. The number of channels and their type are known only at the end
/// of the file.
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

  /// Sets the color of a row. Call in order of rows; rows that are skipped have no color. If one of
  /// the first `channels` values is NaN, the color is counted as bad and becomes zero.
  void set(std::size_t row, const Color& color, std::size_t channels);
  /// Must be called with the text of each number, before set(). If a number has a decimal point or
  /// an exponent, all colors become floating point. If such rows reach only up to 1, integers up to
  /// 255 in other rows are divided by 255, because Geomview scales each row by its numbers.
  void see_word(std::string_view word);

  /// Adds the columns red green blue (alpha), or color_index if rows have only one number. Integer
  /// channels become uchar if they fit, else int, else double; an index becomes int or double. Rows
  /// without a color become white, as in glTF and 3MF, or get index 0. Rows without alpha become
  /// opaque.
  void add_columns(std::size_t rows, Columns& columns);
  std::size_t missing_rows() const;
  std::size_t bad_rows() const { return bad_rows_; }
  std::size_t scaled_rows() const { return scaled_rows_; }

 private:
  bool is_any(std::size_t channel) const;
  Scalar type_of_values() const;
  void scale_integers();
  void add_column(const char* name, Scalar type, std::size_t channel, double absent,
                  Columns& columns) const;

  std::vector<Color> colors_;
  std::vector<char> is_decimal_;  ///< for each row, 1 if one of its numbers is no integer
  bool next_is_decimal_ = false;
  bool is_integer_ = true;
  std::size_t scaled_rows_ = 0;
  std::size_t bad_rows_ = 0;
};

}  // namespace transformesh
