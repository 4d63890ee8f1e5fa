#include "io/document/scalar.h"
#include "io/formats/ply_table.h"

namespace transformesh {
namespace {

/// Reads the values of rows from text.
class TextCursor {
 public:
  TextCursor(TextRows& rows, PlyTable& table) : rows_(rows), table_(table) {}

  void start_row(std::size_t row) {
    row_ = row;
    if (rows_.next_row()) return;
    fail("the data ends before " + table_.row_name(row) + " of " +
         std::to_string(table_.element.rows));
  }

  /// Ends a row. Additional values are only counted, because headers that omit the last properties
  /// are common.
  void end_row() {
    if (!rows_.has_more()) return;
    if (table_.long_rows++ == 0) table_.first_long_row = rows_.place();
  }

  double scalar(const PlyProperty& property) {
    const auto what = [&] { return table_.value_name(row_, property); };
    if (property.type == Scalar::float64) return rows_.number<double>(what);
    if (property.type == Scalar::float32) return static_cast<double>(rows_.number<float>(what));
    const auto value = rows_.number<double>(what);
    check_integer(property, property.type, value);
    return value;
  }

  double coordinate(const PlyProperty& property) {
    const auto what = [&] { return table_.value_name(row_, property); };
    if (property.type == Scalar::float64) return rows_.number_or_nan<double>(what);
    if (property.type == Scalar::float32)
      return static_cast<double>(rows_.number_or_nan<float>(what));
    return scalar(property);
  }

  std::uint64_t count(const PlyProperty& property) {
    const auto what = [&] { return "the length of " + table_.value_name(row_, property); };
    const auto value = rows_.number<double>(what);
    check_integer(property, *property.count_type, value);
    if (value < 0) fail(what() + " is negative");
    return static_cast<std::uint64_t>(value);
  }

  [[noreturn]] void fail(const std::string& what) const { rows_.fail(what); }

 private:
  /// Throws InputError if a value is not an integer of the property's type, because its column
  /// could not store the value. Integers such as 255.000, which some programs write, are accepted.
  void check_integer(const PlyProperty& property, Scalar type, double value) const {
    const double kept = with_scalar(
        type, [&](auto zero) { return static_cast<double>(to_scalar<decltype(zero)>(value)); });
    if (kept == value) return;
    fail(table_.value_name(row_, property) + " does not fit its type " +
         std::string(scalar_name(type, false)));
  }

  TextRows& rows_;
  PlyTable& table_;
  std::size_t row_ = 0;
};

}  // namespace

void read_text_rows(TextRows& rows, PlyTable& table) {
  if (table.element.properties.empty()) return;
  const auto row_count = static_cast<std::size_t>(table.element.rows);
  if (table.element.name == "vertex") table.positions.resize(row_count);
  TextCursor cursor(rows, table);
  std::vector<Index> corners;
  for (std::size_t row = 0; row < row_count; ++row) {
    cursor.start_row(row);
    read_ply_row(cursor, table, row, corners);
    cursor.end_row();
  }
}

}  // namespace transformesh
