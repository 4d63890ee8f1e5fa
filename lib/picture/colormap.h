/// Maps numbers to colors.
///
/// Values of one sign use viridis, from dark purple to yellow. Viridis is perceptually uniform,
/// also for color-blind readers (Smith & van der Walt, 2015, CC0). The table contains every 15th of
/// its 256 colors. Values of both signs range from blue through white at 0 to red, with equal
/// ranges on both sides (Brewer, ColorBrewer 2.0, RdBu of 11 classes, reversed). Colors between
/// those of the tables are interpolated linearly in sRGB. Cost: one look-up. Deterministic.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "picture/linear_color.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct ColorScale {
  double low = 0;
  double high = 1;  ///< >= low

  /// True if 0 is inside the range. Signs are then distinguished.
  bool is_diverging() const { return low < 0 && high > 0; }
  /// Values outside the range get the color of the nearest end. Values that are not finite are
  /// gray.
  Color at(double value) const;
};

/// True if the column exists and is not a list column.
inline bool is_number_column(const Column* column) {
  return column != nullptr && !column->list_count_type;
}

/// Return the column of this name: of the faces, and of the vertices if the faces have none. Return
/// null if there is no such column, or if it is a list column.
const Column* number_column_of_faces(const Mesh& mesh, const std::string& name);
const Column* number_column_of_vertices(const Mesh& mesh, const std::string& name);

/// Returns the range of the finite values of the column in all meshes; 0 to 1 if there are none.
/// Throws UsageError, naming the existing columns, if no mesh has the column.
ColorScale scale_of_column(std::span<const Mesh* const> meshes, const std::string& name);

}  // namespace transformesh
