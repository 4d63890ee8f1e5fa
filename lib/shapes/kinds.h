/// What each kind of shape takes and how it is made.
#pragma once

#include <string>
#include <vector>

#include "transformesh/shapes.h"

namespace transformesh::shapes {

struct Kind {
  std::string name;
  std::vector<std::string> options;     ///< among radius tube gap neck count
  std::vector<std::string> parameters;  ///< their defaults; none or all are given
  double noise = 0;                     ///< default amplitude, per diagonal
  Mesh (*make)(const ShapeOptions&, std::size_t faces, const Progress&) = nullptr;
};

const std::vector<Kind>& kinds();

/// From 1e-50 to 1e50: its fourth power neither overflows nor vanishes.
bool is_sensible_length(double length);

}  // namespace transformesh::shapes
