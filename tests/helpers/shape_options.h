/// Builds options of generated shapes in one expression.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "transformesh/shapes.h"

namespace transformesh::test {

inline ShapeOptions shape(const std::string& kind, std::size_t faces = 0,
                          std::vector<std::string> parameters = {}) {
  ShapeOptions options;
  options.kind = kind;
  options.parameters = std::move(parameters);
  if (faces > 0) options.faces = faces;
  return options;
}

/// Returns all kinds of shapes except `hull`, which needs an input mesh.
inline std::vector<std::string> kinds_without_hull() {
  std::vector<std::string> kinds = shape_kinds();
  std::erase(kinds, "hull");
  return kinds;
}

inline ShapeOptions with_gap(ShapeOptions options, double gap) {
  options.gap = gap;
  return options;
}

inline ShapeOptions with_neck(ShapeOptions options, double neck) {
  options.neck = neck;
  return options;
}

/// Returns a self-intersecting shape for tests of cleaning. A dumbbell gets a neck that is inside
/// out.
inline Mesh workload(const std::string& kind, std::size_t faces, std::uint64_t seed = 1) {
  ShapeOptions options = shape(kind, faces);
  options.seed = seed;
  if (kind == "dumbbell") options.neck = -0.1;
  return make_shape(options);
}

}  // namespace transformesh::test
