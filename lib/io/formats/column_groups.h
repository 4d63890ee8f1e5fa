/// The columns that mean one thing together, by the names that PLY files give them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/columns.h"

namespace transformesh {

using ColumnGroup = std::vector<const Column*>;

/// Each empty where a column is missing, is a list, holds a number that is not finite, or has
/// another type than the others.
ColumnGroup normal_group(const Columns& columns);   ///< nx ny nz
ColumnGroup color_group(const Columns& columns);    ///< red green blue, and alpha where it is there
ColumnGroup texture_group(const Columns& columns);  ///< s t, u v or texture_u texture_v

/// Returns a name for a column of PLY: bytes that are no printable ASCII, and blanks, become `_`. A
/// name that means something else in PLY, such as `x` or `vertex_indices`, gets a `_` at its end.
std::string column_name(std::string_view given);

inline constexpr std::array<const char*, 4> color_channels{"red", "green", "blue", "alpha"};

/// Adds to each of two parts of a mesh the channels of colors that only the other one has: white
/// and opaque, in the type that the other one has.
void add_missing_colors(Columns& first, std::size_t first_rows, Columns& second,
                        std::size_t second_rows);

/// The face column `texcoord`: lists of u and v of three corners, or of none. Null where it is not
/// there, is not like that or holds a number that is not finite.
const Column* corner_texture(const Columns& face_columns);

}  // namespace transformesh
