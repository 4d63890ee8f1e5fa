#include "tm/mesh/columns.h"

#include <algorithm>
#include <cmath>

namespace transformesh {
namespace {

bool is_color(const Column& column) {
  return column.name == "red" || column.name == "green" || column.name == "blue" ||
         column.name == "alpha";
}

bool is_floating(const Column& column) {
  return column.type == Scalar::float32 || column.type == Scalar::float64;
}

std::uint32_t heaviest_source(const RowBlend& row) {
  const auto heaviest = std::max_element(row.weight.begin(), row.weight.end());
  return row.source[static_cast<std::size_t>(heaviest - row.weight.begin())];
}

void append_list(Column& to, const Column& from, std::uint32_t row) {
  const std::size_t first = from.list_offsets[row];
  const std::size_t last = from.list_offsets[row + 1];
  for (std::size_t i = first; i < last; ++i) {
    const double value = from.values[i];  // a copy: `to` may be `from`
    to.values.push_back(value);
  }
  to.list_offsets.push_back(to.values.size());
}

double blended_value(const Column& column, const RowBlend& row) {
  if (row.weight[0] == 1) return column.values[row.source[0]];  // to the bit: a sum loses -0
  const bool rounded = !is_floating(column) && is_color(column);
  if (!is_floating(column) && !rounded) return column.values[heaviest_source(row)];
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

void append_zeros(Column& column, std::size_t rows) {
  if (column.list_count_type) {
    column.list_offsets.insert(column.list_offsets.end(), rows, column.values.size());
  } else {
    column.values.insert(column.values.end(), rows, 0.0);
  }
}

void append_column(Column& to, const Column& from) {
  const std::size_t base = to.values.size();
  to.values.insert(to.values.end(), from.values.begin(), from.values.end());
  for (std::size_t i = 1; i < from.list_offsets.size(); ++i) {
    to.list_offsets.push_back(base + from.list_offsets[i]);
  }
}

}  // namespace

Column* Columns::find(std::string_view name) {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

const Column* Columns::find(std::string_view name) const {
  return const_cast<Columns*>(this)->find(name);  // NOLINT: the mutable overload reads only
}

Column& Columns::get(std::string_view name, Scalar type, std::size_t rows) {
  if (Column* column = find(name)) return *column;
  columns.push_back(Column{std::string(name), type, std::vector<double>(rows, 0.0), {}, {}});
  return columns.back();
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

void Columns::concatenate(const Columns& other, std::size_t rows, std::size_t other_rows) {
  for (Column& column : columns) {
    const Column* source = other.find(column.name);
    const bool fits =
        source && source->list_count_type.has_value() == column.list_count_type.has_value();
    if (fits) {
      append_column(column, *source);
    } else {
      append_zeros(column, other_rows);
    }
  }
  for (const Column& column : other.columns) {
    if (find(column.name)) continue;
    Column& copy = columns.emplace_back(empty_copy(column));
    append_zeros(copy, rows);
    append_column(copy, column);
  }
}

}  // namespace transformesh
