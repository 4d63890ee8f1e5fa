#include "io/formats/column_groups.h"

#include <algorithm>
#include <cmath>

#include "io/document/losses.h"
#include "io/document/scalar.h"
#include "mesh/color_scale.h"

namespace transformesh {
namespace {

using NameList = std::initializer_list<std::string_view>;

ColumnGroup group_of(const Columns& columns, NameList names) {
  if (!has_columns(columns, names)) return {};
  ColumnGroup group;
  for (const std::string_view name : names) {
    group.push_back(columns.find(name));
    if (group.back()->type != group.front()->type) return {};
  }
  return group;
}

ColumnGroup first_group_of(const Columns& columns, std::initializer_list<NameList> choices) {
  for (const NameList& names : choices)
    if (ColumnGroup group = group_of(columns, names); !group.empty()) return group;
  return {};
}

std::size_t list_length(const Column& lists, std::size_t row) {
  return lists.list_offsets[row + 1] - lists.list_offsets[row];
}

}  // namespace

ColumnGroup normal_group(const Columns& columns) { return group_of(columns, {"nx", "ny", "nz"}); }

ColumnGroup color_group(const Columns& columns) {
  return first_group_of(columns, {{"red", "green", "blue", "alpha"}, {"red", "green", "blue"}});
}

bool are_in_range(const ColumnGroup& colors) {
  return std::all_of(colors.begin(), colors.end(), [](const Column* column) {
    const double full = full_intensity(column->type);
    return std::all_of(column->values.begin(), column->values.end(),
                       [&](double value) { return value >= 0 && value <= full; });
  });
}

ColumnGroup texture_group(const Columns& columns) {
  return first_group_of(columns, {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}});
}

const Column* corner_texture(const Columns& face_columns, const Column* outlines) {
  const Column* column = face_columns.find("texcoord");
  if (column == nullptr || !column->list_count_type || !is_floating(column->type)) return nullptr;
  for (std::size_t row = 0; row + 1 < column->list_offsets.size(); ++row) {
    const std::size_t corners = outlines == nullptr ? 3 : list_length(*outlines, row);
    const std::size_t length = list_length(*column, row);
    if (length != 0 && length != 2 * corners) return nullptr;
  }
  const bool are_finite = std::all_of(column->values.begin(), column->values.end(),
                                      [](double value) { return std::isfinite(value); });
  return are_finite ? column : nullptr;
}

void make_corner_texture(const std::vector<Face>& corners, Mesh& mesh) {
  const ColumnGroup group = texture_group(mesh.vertex_columns);
  if (group.empty() || !is_floating(group[0]->type)) return;
  Column lists{"texcoord", group[0]->type, {}, Scalar::uint8, {0}};
  for (const Face& face : corners) {
    for (const Index corner : face)
      for (const Column* column : group) lists.values.push_back(column->values[corner]);
    lists.list_offsets.push_back(lists.values.size());
  }
  const std::array names{group[0]->name, group[1]->name};
  for (const std::string& name : names) mesh.vertex_columns.erase(name);
  mesh.face_columns.erase(lists.name);
  mesh.face_columns.columns.push_back(std::move(lists));
}

std::string column_name(std::string_view given) {
  std::string name(given.empty() ? "_" : given);
  for (char& c : name)
    if (c < '!' || c > '~') c = '_';
  for (const char* taken : {"x", "y", "z", "vertex_indices", "vertex_index"})
    if (name == taken) return name + '_';
  return name;
}

void add_missing_colors(Columns& first, std::size_t first_rows, Columns& second,
                        std::size_t second_rows) {
  const auto add = [](const Columns& from, Columns& to, std::size_t rows) {
    for (const char* channel : color_channels) {
      const Column* given = from.find(channel);
      if (given == nullptr || given->list_count_type || to.find(channel) != nullptr) continue;
      to.get(channel, given->type, rows).values.assign(rows, full_intensity(given->type));
    }
  };
  if (first_rows > 0) add(second, first, first_rows);
  if (second_rows > 0) add(first, second, second_rows);
}

}  // namespace transformesh
