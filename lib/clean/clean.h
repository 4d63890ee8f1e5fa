/// TransforMesh (paper 3): the boundary of { p : w(p) >= winding level } of a closed oriented mesh,
/// as an oriented closed 2-manifold, oriented outwards, w being the winding number. At winding
/// level 1 this removes every self-intersection, inverted part and overlap; surfaces merge, split,
/// open and close.
///
/// Guarantees: every output face is an input face or a piece of one. What takes part in no
/// intersection keeps its coordinates (but for extreme ones: snap_rounding.h), columns and order; a
/// manifold with nothing to clean comes back unchanged. Equal positions are one point. The output
/// has no self-intersection in its coordinates as rounded to `coordinate` (coincident vertices and
/// edges may touch), and no face without area. Exact; deterministic for any number of threads. Open
/// meshes keep their borders (paper 4.6).
///
/// Throws InputError (not oriented: two or more faces left over along an edge, but for borders of a
/// stitched mesh that lie partly upon each other), UsageError (static_test on an open mesh),
/// GoalError (nothing has w >= winding level; rounding could not be repaired, with the place;
/// `refuse` and there is something to change). Cost: O(n log n + k log k) for k intersecting pairs
/// on usual meshes; about 250 bytes a face.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clean/exterior/exterior_method.h"
#include "mesh/components.h"
#include "support/progress.h"

namespace transformesh {

struct CleanOptions {
  ExteriorMethod method = ExteriorMethod::grow;
  int winding_level = 1;                ///< 1 is the union, 2 the intersection of two operands
  bool outermost = false;               ///< drop cavities, and components that float in them
  bool refuse = false;                  ///< throw rather than change anything
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

struct CleanResult {
  Mesh mesh;
  bool changed = false;
  std::size_t pairs = 0;          ///< intersecting face pairs in the input
  std::size_t cut_faces = 0;      ///< input faces that were cut
  std::size_t removed_faces = 0;  ///< whole input faces that were dropped
  std::size_t new_vertices = 0;
  std::size_t copied_vertices = 0;  ///< duplicates made at singular vertices and edges
  std::size_t patches = 0;
  std::size_t rays = 0;
  std::size_t dropped_components = 0;        ///< by `outermost`
  std::size_t rounding_repairs = 0;          ///< rounds of repair after rounding (snap_rounding.h)
  std::size_t rounding_places = 0;           ///< places where rounding broke faces
  double rounding_displacement = 0;          ///< how far rounding moved the surface at most
  double rounding_spacings = 0;              ///< the same in spacings of numbers at each place
  std::vector<std::string> dropped_columns;  ///< texture coordinates of corners, on cut faces
  bool dropped_source_points = false;        ///< likewise (source_points.h)
  std::optional<Connectivity> connectivity;  ///< of the mesh, where there was nothing to change
};

CleanResult clean(const Mesh& mesh, const CleanOptions& options = {},
                  const Progress& progress = Progress());

}  // namespace transformesh
