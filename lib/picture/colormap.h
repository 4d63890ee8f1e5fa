/// Numbers as colors: which color stands for a value, and which values a picture spans.
/// One sign: viridis, from dark purple to yellow, even to the eye and to the color-blind (Smith &
/// van der Walt, 2015, CC0; every 15th of its 256 colors). Both signs: blue over white at 0 to red,
/// as far either way (Brewer, ColorBrewer 2.0, RdBu of 11 classes, reversed). Between the numbers
/// of the tables sRGB is linear. Cost: a look-up. Deterministic.
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

  /// Whether 0 is within, so that signs are distinguished.
  bool is_diverging() const { return low < 0 && high > 0; }
  /// Values beyond the ends have the color of the end. Gray where the value is not finite.
  Color at(double value) const;
};

/// A column of numbers (no lists) of the faces, else of the vertices; null where neither has it.
const Column* number_column_of_faces(const Mesh& mesh, const std::string& name);
const Column* number_column_of_vertices(const Mesh& mesh, const std::string& name);

/// From the least to the largest finite value that the column has in any of the meshes; 0 to 1
/// where there is none. Throws UsageError where no mesh has the column, naming those that exist.
ColorScale scale_of_column(std::span<const Mesh* const> meshes, const std::string& name);

}  // namespace transformesh
