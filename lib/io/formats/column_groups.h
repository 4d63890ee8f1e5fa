/// Finds groups of columns that belong together, such as a normal, by their names in PLY files.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

using ColumnGroup = std::vector<const Column*>;

/// Each of the following functions returns the columns of one group. The result is empty if a
/// column is missing, is a list, contains a non-finite number, or has another type than the others.
ColumnGroup normal_group(const Columns& columns);  ///< returns the columns nx ny nz
/// Returns the columns red green blue, and alpha if present.
ColumnGroup color_group(const Columns& columns);
/// True if all values are from 0 to full intensity.
bool are_in_range(const ColumnGroup& colors);
ColumnGroup texture_group(const Columns& columns);  ///< returns s t, u v or texture_u texture_v

/// Returns `given` as a valid name of a PLY column. Blanks and bytes other than printable ASCII
/// become `_`. If the name has another meaning in PLY, such as `x` or `vertex_indices`, a `_` is
/// appended.
std::string column_name(std::string_view given);

inline constexpr std::array<const char*, 4> color_channels{"red", "green", "blue", "alpha"};

/// If one of two parts of a mesh has a color channel and the other does not, adds the channel to
/// the other part. The added values are white and opaque, in the same type.
void add_missing_colors(Columns& first, std::size_t first_rows, Columns& second,
                        std::size_t second_rows);

/// Replaces the columns of texture_group() by the face column `texcoord`. The corners of the faces
/// have the vertices `corners`. Does nothing if these columns are missing or integers.
void make_corner_texture(const std::vector<Face>& corners, Mesh& mesh);

/// Returns the face column `texcoord`, which has a list of (u, v) pairs for each face: one pair for
/// each corner, or an empty list. Faces have the corners in MergedPolygons::outlines if given,
/// otherwise three. Returns null if the column is missing, has other lists, or contains a
/// non-finite number.
const Column* corner_texture(const Columns& face_columns, const Column* outlines = nullptr);

}  // namespace transformesh
