/// Closes the holes of a mesh. Each border loop gets a patch that is triangulated, refined and
/// faired. A patch that intersects the mesh, an earlier patch or itself, or has a face without
/// area, is tried again without fairing, then unrefined, then with another triangulation. If no
/// patch fits, the hole stays open. Intersections are decided exactly, in coordinates as they will
/// be written. Intersections of the input are no obstacle.
///
/// Guarantees: vertices and faces of the input stay, with order and columns; new ones follow. The
/// result is an oriented manifold. Number columns of new vertices are the mean of the three
/// nearest vertices of the border, weighted by inverse distance; columns of new faces are 0, and
/// empty for lists. Deterministic for any number of threads.
///
/// Throws InputError for a mesh that is no oriented manifold, saying where and what mends it.
/// Cost: that of the patches, and O(n) for each hole.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct FillOptions {
  std::size_t max_edges = std::numeric_limits<std::size_t>::max();  ///< of a hole; at least 3
  double max_diameter = std::numeric_limits<double>::infinity();  ///< of its box; input units; > 0
  bool refine = true;  ///< add vertices, as dense as those around
  bool fair = true;    ///< continue what is around smoothly; needs `refine`
  bool allow_self_intersections =
      false;                            ///< close what is left all the same, for clean() afterwards
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

/// A hole that stays open.
struct OpenHole {
  Index vertex = 0;       ///< one on its border
  std::size_t edges = 0;  ///< of its border
  double length = 0;      ///< of its border; input units
};

struct FillResult {
  std::size_t holes = 0;    ///< of the input
  std::size_t faired = 0;   ///< closed by a faired patch
  std::size_t refined = 0;  ///< closed by one that is refined, not faired
  std::size_t plain = 0;    ///< closed by one without new vertices
  std::size_t crossed = 0;  ///< closed by one that intersects, by `allow_self_intersections`
  std::size_t new_vertices = 0, new_faces = 0;
  bool dropped_source_points = false;  ///< carry.h
  std::vector<OpenHole> too_large;     ///< beyond the limits
  std::vector<OpenHole> crossing;      ///< every patch would intersect
  /// Every patch would have a face without area, or an edge that has two faces already.
  std::vector<OpenHole> flat;
  std::size_t filled() const { return faired + refined + plain + crossed; }
};

FillResult fill_holes(Mesh& mesh, const FillOptions& options = {},
                      const Progress& progress = Progress());

}  // namespace transformesh
