/// The kinds of shapes: their options and constructors.
#pragma once

#include <string>
#include <vector>

#include "transformesh/shapes.h"

namespace transformesh::shapes {

struct Kind {
  std::string name;
  std::vector<std::string> options;  ///< options of this kind, of radius, tube, gap, neck and count
  std::vector<std::string> parameters;  ///< default parameters; users give all or none
  double noise = 0;                     ///< default noise amplitude, as a fraction of the diagonal
  Mesh (*make)(const ShapeOptions&, std::size_t faces, const Progress&) = nullptr;
};

const std::vector<Kind>& kinds();

/// True if the length is in [1e-50, 1e50], so that its fourth power neither overflows nor vanishes.
bool is_sensible_length(double length);

}  // namespace transformesh::shapes
