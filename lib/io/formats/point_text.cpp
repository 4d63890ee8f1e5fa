#include "io/formats/point_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/formats/finite_values.h"
#include "io/formats/text_rows.h"
#include "io/streams/expand.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

constexpr std::array<const char*, 6> value_names{"x", "y", "z", "nx", "ny", "nz"};

bool has_off_name(const Source& source) {
  const std::string_view name = without_gz(source.name);
  return name.ends_with(".off") || name.ends_with(".OFF");
}

// Returns the number of words in the row, which must be three or six. Throws InputError for any
// other number.
std::size_t row_length(const TextRows& rows) {
  const std::size_t length = rows.words_left();
  if (length != 3 && length != 6) {
    rows.fail("a point has 3 numbers (x y z) or 6 (and nx ny nz), but this line has " +
              std::to_string(length));
  }
  return length;
}

std::array<double, 6> read_row(TextRows& rows, std::size_t length, std::size_t point) {
  std::array<double, 6> values{};
  for (std::size_t i = 0; i < length; ++i) {
    values[i] = rows.number_or_nan<double>(
        [&] { return std::string(value_names[i]) + " of point " + std::to_string(point); });
  }
  rows.end_row([&] { return "point " + std::to_string(point); });
  return values;
}

// True if the three columns are colors instead of normals. Colors are bytes, or fractions in rows
// without unit length. Rows of normals have unit length within their precision.
bool are_colors(const std::array<std::vector<double>, 3>& columns) {
  double largest = 0;
  bool are_bytes = true, are_shares = true, are_unit = true;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    double square = 0;
    const bool is_finite = std::isfinite(columns[0][i] + columns[1][i] + columns[2][i]);
    for (const std::vector<double>& column : columns) {
      const double value = column[i];
      if (std::isnan(value)) continue;
      square += value * value;
      largest = std::max(largest, value);
      are_bytes = are_bytes && value >= 0 && value <= 255 && value == std::floor(value);
      are_shares = are_shares && value >= 0 && value <= 1;
    }
    are_unit = are_unit && (!is_finite || std::abs(square - 1) < 0.05);
  }
  return !are_unit && ((are_bytes && largest > 2) || (are_shares && columns[0].size() > 3));
}

}  // namespace

bool is_point_text(const Source& source) {
  if (source.bytes.substr(0, 4096).find('\0') != std::string_view::npos) return false;
  TextRows rows(source, 0, rules_with_comments);
  if (!rows.next_row()) return false;
  const std::size_t length = rows.words_left();
  if (length != 6 && (length != 3 || has_off_name(source))) return false;
  while (rows.has_more()) {
    if (!is_number(rows.word())) return false;
  }
  return true;
}

void check_point_text(const Source& source) {
  if (source.bytes.substr(0, 4096).find('\0') != std::string_view::npos) return;
  TextRows rows(source, 0, rules_with_comments);
  if (!rows.next_row()) return;
  std::string words(rows.skip_row());
  const bool has_commas = words.find_first_of(",;") != std::string::npos;
  std::replace_if(
      words.begin(), words.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  const Source spaced{words, source.name};
  TextRows numbers(spaced, 0, rules_with_comments);
  if (!numbers.next_row()) return;
  const std::size_t length = numbers.words_left();
  while (numbers.has_more())
    if (!is_number(numbers.word())) return;
  if (has_commas)
    rows.fail(
        "numbers of a point must be separated by blanks: replace the commas, for example with the "
        "command tr , ' '");
  rows.fail("a point has 3 numbers (x y z) or 6 (and nx ny nz), but this line has " +
            std::to_string(length) + ": take the first three, by awk '{ print $1, $2, $3 }'");
}

ReadResult read_point_text(const Source& source) {
  ReadResult result;
  result.document.style.format = Format::xyz;
  result.document.style.element_order = {"vertex"};
  Mesh& mesh = result.document.mesh;
  std::array<std::vector<double>, 3> normals;
  TextRows rows(source, 0, rules_with_comments);
  std::size_t length = 0;
  while (rows.next_row()) {
    if (length == 0) length = row_length(rows);
    const auto values = read_row(rows, length, mesh.positions.size());
    mesh.positions.emplace_back(values[0], values[1], values[2]);
    for (std::size_t i = 0; i < 3 && length == 6; ++i) normals[i].push_back(values[3 + i]);
  }
  const bool has_normals = length == 6 && !are_colors(normals);
  for (std::size_t i = 0; i < 3 && has_normals; ++i) {
    Column& column = mesh.vertex_columns.get(value_names[3 + i], Scalar::float64, 0);
    column.values = std::move(normals[i]);
  }
  if (length == 6 && !has_normals)
    result.notes.emplace_back(
        "points: the last three numbers of each line look like colors and are left out; a first "
        "line 'x y z red green blue' keeps them");
  result.document.style.comments = std::move(rows.comments);
  zero_values_not_finite(mesh.vertex_columns, source, "point", "points", result.notes);
  drop_points_not_finite(mesh, 0, "points", result.notes);
  return result;
}

}  // namespace transformesh
