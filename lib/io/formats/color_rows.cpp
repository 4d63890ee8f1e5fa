#include "io/formats/color_rows.h"

#include <algorithm>
#include <cmath>

#include "io/document/scalar.h"

namespace transformesh {

void ColorRows::set(std::size_t row, const Color& color, std::size_t channels) {
  colors_.resize(row, no_color);
  colors_.push_back(color);
  is_decimal_.resize(row, 0);
  is_decimal_.push_back(next_is_decimal_ ? 1 : 0);
  next_is_decimal_ = false;
  const auto begin = colors_.back().begin(), end = begin + static_cast<std::ptrdiff_t>(channels);
  if (std::none_of(begin, end, [](double value) { return std::isnan(value); })) return;
  std::fill(begin, end, 0.0);
  ++bad_rows_;
}

void ColorRows::see_word(std::string_view word) {
  next_is_decimal_ = next_is_decimal_ || word.find_first_of(".eE") != std::string_view::npos;
  is_integer_ = is_integer_ && !next_is_decimal_;
}

void ColorRows::scale_integers() {
  const auto largest = [](const Color& color) {
    double most = 0;
    for (const double value : color) most = std::fmax(most, value);
    return most;
  };
  double most = 0;  // the largest value in rows with decimals
  for (std::size_t row = 0; row < is_decimal_.size(); ++row)
    if (is_decimal_[row] != 0) most = std::max(most, largest(colors_[row]));
  if (!(most > 0 && most <= 1)) return;
  for (std::size_t row = 0; row < is_decimal_.size(); ++row) {
    Color& color = colors_[row];
    const double size = largest(color);
    if (is_decimal_[row] != 0 || std::isnan(color[1]) || size <= 1 || size > 255) continue;
    for (double& value : color) value /= 255;
    ++scaled_rows_;
  }
}

void ColorRows::add_columns(std::size_t rows, Columns& columns) {
  if (colors_.empty()) return;
  scale_integers();
  colors_.resize(rows, no_color);
  const Scalar type = type_of_values();
  if (!is_any(1)) {
    const Scalar index_type = type == Scalar::uint8 ? Scalar::int32 : type;
    return add_column("color_index", index_type, 0, 0, columns);
  }
  const double full = type == Scalar::float64 ? 1 : 255;
  add_column("red", type, 0, full, columns);
  add_column("green", type, 1, full, columns);
  add_column("blue", type, 2, full, columns);
  if (is_any(3)) add_column("alpha", type, 3, full, columns);
}

std::size_t ColorRows::missing_rows() const {
  return static_cast<std::size_t>(std::count_if(colors_.begin(), colors_.end(),
                                                [](const Color& c) { return std::isnan(c[0]); }));
}

bool ColorRows::is_any(std::size_t channel) const {
  return std::any_of(colors_.begin(), colors_.end(),
                     [&](const Color& color) { return !std::isnan(color[channel]); });
}

Scalar ColorRows::type_of_values() const {
  if (!is_integer_) return Scalar::float64;
  for (const Scalar type : {Scalar::uint8, Scalar::int32}) {
    const auto fits = [&](double value) {
      return std::isnan(value) || with_scalar(type, [&](auto zero) {
               return static_cast<double>(to_scalar<decltype(zero)>(value)) == value;
             });
    };
    if (std::all_of(colors_.begin(), colors_.end(), [&](const Color& color) {
          return std::all_of(color.begin(), color.end(), fits);
        }))
      return type;
  }
  return Scalar::float64;
}

void ColorRows::add_column(const char* name, Scalar type, std::size_t channel, double absent,
                           Columns& columns) const {
  Column& column = columns.get(name, type, colors_.size());
  for (std::size_t row = 0; row < colors_.size(); ++row) {
    const double value = colors_[row][channel];
    column.values[row] = std::isnan(value) ? absent : value;
  }
}

}  // namespace transformesh
