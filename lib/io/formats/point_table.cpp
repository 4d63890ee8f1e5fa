#include "io/formats/point_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/formats/column_groups.h"
#include "io/formats/finite_values.h"
#include "io/formats/text_rows.h"
#include "mesh/index_limits.h"
#include "support/counted.h"
#include "support/lower_case.h"

namespace transformesh {
namespace {

using ColumnNames = std::vector<std::string>;

bool separates(char c) { return c == ',' || c == ';'; }

std::string with_blanks(std::string_view text) {
  std::string result(text);
  std::replace_if(result.begin(), result.end(), separates, ' ');
  return result;
}

/// Returns the name of the column for a name in the header line, such as `red` for `R`.
std::string column_of(std::string_view word) {
  std::string name = lower_case(word);
  std::erase_if(name, [](char c) { return c == '"' || c == '/'; });
  constexpr std::array<std::array<std::string_view, 2>, 7> other_names{{{"r", "red"},
                                                                        {"g", "green"},
                                                                        {"b", "blue"},
                                                                        {"a", "alpha"},
                                                                        {"normal_x", "nx"},
                                                                        {"normal_y", "ny"},
                                                                        {"normal_z", "nz"}}};
  for (const auto& [given, column] : other_names)
    if (name == given) return std::string(column);
  return name;
}

ColumnNames words_of(TextRows& rows) {
  ColumnNames words;
  while (rows.has_more()) words.emplace_back(rows.word());
  return words;
}

/// Returns the column names in the first line, or default names if the line is a number of points.
ColumnNames column_names_in_header(const std::string& text) {
  const Source source{text, ""};
  TextRows rows(source, 0, rules_with_comments);
  if (!rows.next_row()) return {};
  ColumnNames names = words_of(rows);
  if (!rows.next_row() || !is_number(rows.peek())) return {};
  if (names.size() == 1 && names[0].find_first_not_of("0123456789") == std::string::npos) {
    const std::size_t width = rows.words_left();
    names = {"x", "y", "z"};
    if (width == 4 || width == 7) names.emplace_back("intensity");
    if (width == 6 || width == 7) names.insert(names.end(), {"red", "green", "blue"});
    return names.size() == width ? names : ColumnNames();
  }
  if (std::any_of(names.begin(), names.end(), is_number)) return {};
  for (std::string& name : names) name = column_of(name);
  std::erase(names, "");
  for (const char* needed : {"x", "y", "z"})
    if (std::count(names.begin(), names.end(), needed) != 1) return {};
  return names;
}

bool are_bytes(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) {
    return value >= 0 && value <= 255 && value == std::floor(value);
  });
}

class TableReader {
 public:
  explicit TableReader(const Source& source)
      : text_(with_blanks(source.bytes)),
        source_{text_, source.name, source.is_strict},
        rows_(source_, 0, rules_with_comments),
        names_(column_names_in_header(text_)),
        values_(names_.size()) {}

  ReadResult read() {
    rows_.next_row();
    rows_.skip_row();
    while (rows_.next_row()) read_row();
    make_mesh();
    return std::move(result_);
  }

 private:
  void read_row() {
    const auto row = [&] { return "point " + std::to_string(values_.back().size()); };
    for (std::size_t i = 0; i < names_.size(); ++i)
      values_[i].push_back(rows_.number_or_nan<double>([&] { return names_[i] + " of " + row(); }));
    rows_.end_row(row);
  }

  const std::vector<double>& values_of(const char* name) const {
    return values_[static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) -
                                            names_.begin())];
  }

  void make_mesh() {
    Style& style = result_.document.style;
    style.format = Format::xyz;
    style.element_order = {"vertex"};
    Mesh& mesh = result_.document.mesh;
    const std::vector<double>&x = values_of("x"), &y = values_of("y"), &z = values_of("z");
    if (x.size() >= no_index) source_.fail(too_many_vertices);
    for (std::size_t i = 0; i < x.size(); ++i) mesh.positions.emplace_back(x[i], y[i], z[i]);
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (names_[i] != "x" && names_[i] != "y" && names_[i] != "z")
        add_column(i, mesh.vertex_columns);
    zero_values_not_finite(mesh.vertex_columns, source_, "point", "points", result_.notes);
    drop_points_not_finite(mesh, 0, "points", result_.notes);
  }

  void add_column(std::size_t i, Columns& columns) {
    const bool is_color =
        std::find(color_channels.begin(), color_channels.end(), names_[i]) != color_channels.end();
    const Scalar type = is_color && are_bytes(values_[i]) ? Scalar::uint8 : Scalar::float64;
    columns.get(column_name(names_[i]), type, 0).values = std::move(values_[i]);
  }

  std::string text_;
  Source source_;
  TextRows rows_;
  ColumnNames names_;
  std::vector<std::vector<double>> values_;
  ReadResult result_;
};

}  // namespace

bool is_point_table(const Source& source) {
  // Number of bytes that are searched for a header line; chosen by hand. If comments before the
  // header are longer, it is not recognized.
  constexpr std::size_t searched = 4096;
  const std::string_view start = source.bytes.substr(0, searched);
  return start.find('\0') == std::string_view::npos &&
         !column_names_in_header(with_blanks(start)).empty();
}

ReadResult read_point_table(const Source& source) { return TableReader(source).read(); }

}  // namespace transformesh
