/// Columns that form a group, such as a normal, by their names in PLY files.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/columns.h"

namespace transformesh {

using ColumnGroup = std::vector<const Column*>;

/// Return the columns of a group. A group is empty if a column is missing, is a list, holds a
/// non-finite number, or has another type than the others.
ColumnGroup normal_group(const Columns& columns);   ///< nx ny nz
ColumnGroup color_group(const Columns& columns);    ///< red green blue, and alpha if present
ColumnGroup texture_group(const Columns& columns);  ///< s t, u v or texture_u texture_v

/// Returns a valid name for a PLY column. Blanks and bytes other than printable ASCII become `_`.
/// Names with another meaning in PLY, such as `x` or `vertex_indices`, get a `_` appended.
std::string column_name(std::string_view given);

inline constexpr std::array<const char*, 4> color_channels{"red", "green", "blue", "alpha"};

/// Adds the color channels that only one of two parts of a mesh has to the other part: white and
/// opaque, of the same type.
void add_missing_colors(Columns& first, std::size_t first_rows, Columns& second,
                        std::size_t second_rows);

/// Returns the face column `texcoord`, lists of (u, v) of all corners or of none. The corners are
/// those of MergedPolygons::outlines if given, otherwise three. Null if the column is missing, has
/// other lists, or holds a non-finite number.
const Column* corner_texture(const Columns& face_columns, const Column* outlines = nullptr);

}  // namespace transformesh
