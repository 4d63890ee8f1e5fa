/// Closes the holes of a mesh. Each border loop gets a patch that is triangulated, refined and
/// faired; an opening with loops in it gets one patch. A patch is rejected if it intersects the
/// mesh, an earlier patch or itself, or has a face without area. Then patches without fairing or
/// refinement, and with another triangulation, are tried. If none fits, the hole stays open.
/// Intersections, except those of the input, are decided exactly in coordinates as written.
/// Holes may touch at a vertex: its copies are joined, or it is copied for each umbrella if holes
/// stay open. A hole of two bodies that touch along an edge is cut there: the ends are copied.
/// Other input vertices and all input faces stay, with order and columns; new ones follow. The
/// result is an oriented manifold. Numeric columns of new vertices are the mean of the three
/// nearest border vertices, weighted by inverse distance. Columns of new faces are 0, and empty for
/// lists. Deterministic for any number of threads. Throws InputError if an edge is not manifold or
/// not oriented, naming the place. Cost: that of the patches, and O(n) for each hole.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct FillOptions {
  /// Holes with more border edges than this stay open; >= 3.
  std::size_t max_edges = std::numeric_limits<std::size_t>::max();
  /// Holes whose box has a longer diagonal than this stay open; input units; > 0.
  double max_diameter = std::numeric_limits<double>::infinity();
  bool refine = true;  ///< add vertices, as dense as those around the hole
  bool fair = true;    ///< continue the surrounding surface smoothly; needs `refine`
  bool allow_self_intersections = false;  ///< close holes by an intersecting patch if no other fits
  Scalar coordinate = Scalar::float64;    ///< the type in which positions will be written
};

/// A hole that stays open.
struct OpenHole {
  Index vertex = 0;       ///< a vertex on the border of the hole
  std::size_t edges = 0;  ///< number of edges of the border
  double length = 0;      ///< length of the border; input units
};

struct FillResult {
  std::size_t holes = 0;    ///< number of holes, after cuts
  std::size_t faired = 0;   ///< holes closed by a faired patch
  std::size_t refined = 0;  ///< holes closed by a refined patch that is not faired
  std::size_t plain = 0;    ///< holes closed by a patch without new vertices
  std::size_t crossed = 0;  ///< holes closed by an intersecting patch (`allow_self_intersections`)
  std::size_t new_vertices = 0, new_faces = 0, cut_edges = 0;  ///< edges where bodies touch
  bool dropped_source_points = false;  ///< source points were dropped (carry.h)
  std::vector<OpenHole> too_large;     ///< holes larger than `max_edges` or `max_diameter`
  std::vector<OpenHole> crossing;      ///< holes for which each patch would intersect a face
  /// Holes for which each patch would have a face without area or an edge that has two faces.
  std::vector<OpenHole> flat;
  std::size_t filled() const { return faired + refined + plain + crossed; }
};

FillResult fill_holes(Mesh& mesh, const FillOptions& options = {},
                      const Progress& progress = Progress());

}  // namespace transformesh
