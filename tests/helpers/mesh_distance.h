/// Measures the distance between two meshes by testing all pairs of faces.
#pragma once

#include <algorithm>
#include <limits>

#include "geometry/keep_out.h"
#include "mesh/triangle.h"

namespace transformesh::test {

inline double distance_of_meshes(const Mesh& first, const Mesh& second) {
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < first.faces.size(); ++f)
    for (Index g = 0; g < second.faces.size(); ++g)
      least = std::min(least, distance_of(triangle_of(first, f), triangle_of(second, g)));
  return least;
}

}  // namespace transformesh::test
