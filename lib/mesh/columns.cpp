#include "transformesh/columns.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "mesh/color_scale.h"
#include "mesh/coordinate_spacing.h"

namespace transformesh {
namespace {

bool is_color(const Column& column) {
  return column.name == "red" || column.name == "green" || column.name == "blue" ||
         column.name == "alpha";
}

bool is_floating(Scalar type) { return type == Scalar::float32 || type == Scalar::float64; }

/// True if `type` can represent every value of `other`.
bool holds(Scalar type, Scalar other) {
  constexpr std::array<int, 8> bits{7, 8, 15, 16, 31, 32, 24, 53};
  constexpr std::array<bool, 8> is_signed{true, false, true, false, true, false, true, true};
  const auto [t, o] = std::pair{static_cast<std::size_t>(type), static_cast<std::size_t>(other)};
  if (is_floating(other) && !is_floating(type)) return false;
  return bits[t] >= bits[o] && (is_signed[t] || !is_signed[o]);
}

/// Returns a type that can represent all values of both types.
Scalar united(Scalar first, Scalar second) {
  for (const Scalar type : {first, second, Scalar::int16, Scalar::int32})
    if (holds(type, first) && holds(type, second)) return type;
  return Scalar::float64;
}

std::uint32_t heaviest_source(const RowBlend& row) {
  const auto* const heaviest = std::max_element(row.weight.begin(), row.weight.end());
  return row.source[static_cast<std::size_t>(heaviest - row.weight.begin())];
}

void append_list(Column& to, const Column& from, std::uint32_t row) {
  const std::size_t first = from.list_offsets[row];
  const std::size_t last = from.list_offsets[row + 1];
  for (std::size_t i = first; i < last; ++i) {
    const double value = from.values[i];  // a copy, because `to` may alias `from`
    to.values.push_back(value);
  }
  to.list_offsets.push_back(to.values.size());
}

double blended_value(const Column& column, const RowBlend& row) {
  if (row.weight[0] == 1) return column.values[row.source[0]];  // a sum would turn -0 into 0
  const bool rounded = !is_floating(column.type) && is_color(column);
  if (!is_floating(column.type) && !rounded) return column.values[heaviest_source(row)];
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (row.weight[i] != 0) sum += row.weight[i] * column.values[row.source[i]];
  }
  return rounded ? std::round(sum) : sum;
}

void append_row(Column& to, const Column& from, const RowBlend& row) {
  if (from.list_count_type) {
    append_list(to, from, heaviest_source(row));
  } else {
    to.values.push_back(blended_value(from, row));
  }
}

Column empty_copy(const Column& column) {
  Column copy{column.name, column.type, {}, column.list_count_type, {}};
  if (copy.list_count_type) copy.list_offsets.push_back(0);
  return copy;
}

/// Returns the default of a missing value. Colors are white: black would look like a color of the
/// mesh.
double missing_value(const Column& column) {
  return is_color(column) ? full_intensity(column.type) : 0;
}

void append_missing(Column& column, std::size_t rows) {
  if (column.list_count_type) {
    column.list_offsets.insert(column.list_offsets.end(), rows, column.values.size());
  } else {
    column.values.insert(column.values.end(), rows, missing_value(column));
  }
}

/// Returns a type that can represent all colors of both types. If the types have different scales,
/// only a floating type and ushort can hold the colors of the other scale.
Scalar united_color(Scalar first, Scalar second) {
  const Scalar type = united(first, second);
  const bool has_same_scale = full_intensity(first) == full_intensity(second);
  const bool is_kept = has_same_scale || is_floating(type) || type == Scalar::uint16;
  return is_kept ? type : Scalar::float64;
}

/// Gives a color column another type. Converts its values to the scale of the type.
void convert_color(Column& column, Scalar type) {
  const double from = full_intensity(column.type), to = full_intensity(type);
  column.type = type;
  if (from == to) return;
  for (double& value : column.values) {
    value = to > from ? value * (to / from) : value / (from / to);  // both quotients are integers
    if (type == Scalar::float32) value = round_to_single(value);
  }
}

void append_column(Column& to, const Column& from) {
  if (is_color(to) && !to.list_count_type && to.type != from.type) {
    const Scalar type = united_color(to.type, from.type);
    convert_color(to, type);
    Column converted = from;
    convert_color(converted, type);
    to.values.insert(to.values.end(), converted.values.begin(), converted.values.end());
    return;
  }
  to.type = united(to.type, from.type);
  if (to.list_count_type) to.list_count_type = united(*to.list_count_type, *from.list_count_type);
  const std::size_t base = to.values.size();
  to.values.insert(to.values.end(), from.values.begin(), from.values.end());
  for (std::size_t i = 1; i < from.list_offsets.size(); ++i) {
    to.list_offsets.push_back(base + from.list_offsets[i]);
  }
}

/// Maps each name to its first column.
std::unordered_map<std::string_view, const Column*> by_name(const std::vector<Column>& columns) {
  std::unordered_map<std::string_view, const Column*> found;
  for (const Column& column : columns) found.emplace(column.name, &column);
  return found;
}

}  // namespace

Column* Columns::find(std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

const Column* Columns::find(std::string_view name) const {
  return const_cast<Columns*>(this)->find(name);  // NOLINT: the mutable overload only reads
}

Column& Columns::get(std::string_view name, Scalar type, std::size_t rows) {
  Column fresh{std::string(name), type, std::vector<double>(rows, 0.0), {}, {}};
  if (Column* column = find(name)) return *column = std::move(fresh);
  return columns.emplace_back(std::move(fresh));
}

void Columns::erase(std::string_view name) {
  std::erase_if(columns, [&](const Column& column) { return column.name == name; });
}

Columns Columns::select(std::span<const std::uint32_t> rows) const {
  Columns result;
  for (const Column& column : columns) {
    Column& copy = result.columns.emplace_back(empty_copy(column));
    if (!column.list_count_type) copy.values.reserve(rows.size());
    for (const std::uint32_t row : rows) {
      if (column.list_count_type) {
        append_list(copy, column, row);
      } else {
        copy.values.push_back(column.values[row]);
      }
    }
  }
  return result;
}

Columns Columns::blend(std::span<const RowBlend> rows) const {
  Columns result;
  for (const Column& column : columns) {
    Column& copy = result.columns.emplace_back(empty_copy(column));
    for (const RowBlend& row : rows) append_row(copy, column, row);
  }
  return result;
}

void Columns::append(const RowBlend& row) {
  for (Column& column : columns) append_row(column, column, row);
}

std::vector<std::string> Columns::concatenate(const Columns& other, std::size_t rows,
                                              std::size_t other_rows) {
  std::vector<std::string> misfits;
  const auto sources = by_name(other.columns);
  const auto known = by_name(columns);
  for (Column& column : columns) {
    const Column* source = sources.contains(column.name) ? sources.at(column.name) : nullptr;
    const bool fits =
        source && source->list_count_type.has_value() == column.list_count_type.has_value();
    if (fits) {
      append_column(column, *source);
    } else {
      append_missing(column, other_rows);
      if (source) misfits.push_back(column.name);
    }
  }
  std::vector<Column> added;
  for (const Column& column : other.columns) {
    if (known.contains(column.name) || sources.at(column.name) != &column) continue;
    Column& copy = added.emplace_back(empty_copy(column));
    append_missing(copy, rows);
    append_column(copy, column);
  }
  std::move(added.begin(), added.end(), std::back_inserter(columns));
  return misfits;
}

}  // namespace transformesh
