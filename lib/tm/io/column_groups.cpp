#include "tm/io/column_groups.h"

#include "tm/io/losses.h"

namespace transformesh {
namespace {

using Names = std::initializer_list<std::string_view>;

ColumnGroup group_of(const Columns& columns, Names names) {
  if (!has_columns(columns, names)) return {};
  ColumnGroup group;
  for (const std::string_view name : names) {
    group.push_back(columns.find(name));
    if (group.back()->type != group.front()->type) return {};
  }
  return group;
}

ColumnGroup first_group_of(const Columns& columns, std::initializer_list<Names> choices) {
  for (const Names& names : choices)
    if (ColumnGroup group = group_of(columns, names); !group.empty()) return group;
  return {};
}

}  // namespace

ColumnGroup normal_group(const Columns& columns) { return group_of(columns, {"nx", "ny", "nz"}); }

ColumnGroup color_group(const Columns& columns) {
  return first_group_of(columns, {{"red", "green", "blue", "alpha"}, {"red", "green", "blue"}});
}

ColumnGroup texture_group(const Columns& columns) {
  return first_group_of(columns, {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}});
}

}  // namespace transformesh
