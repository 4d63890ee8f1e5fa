/// Computes the boundary of { p : w(p) >= winding level } (TransforMesh, paper 3), where w(p) is
/// the winding number of a closed oriented mesh. It is a closed 2-manifold, oriented outwards.
/// Level 1 removes every self-intersection, inverted region and overlap; surfaces merge and split.
///
/// Guarantees: every output face is an input face or a part of one. Faces without intersection keep
/// coordinates, columns and order, except near faces that rounding breaks. A manifold with nothing
/// to clean is unchanged. Vertices at equal positions count as one. Rounded to `coordinate`, the
/// output has no self-intersection (coincident vertices and edges may touch) and no face without
/// area. Rounding the output and repairing it moves no part of the surface farther than
/// `rounding_displacement` (clean_result.h). In a mesh with borders, the closed part is cleaned as
/// if it were alone. Open components lose their parts inside the closed part, and parts behind
/// another open component that intersects them (docs/design/open-meshes.md). Throws InputError if
/// the mesh is not oriented, and UsageError for static_test on an open mesh. Throws GoalError if no
/// point reaches the level, if rounding cannot be repaired, or if `refuse` forbids a change.
/// Deterministic. Cost: O(n log n + k log k) for n faces with k intersecting pairs.
///
/// A `box` restricts cleaning to faces whose first vertex is in it (paper 4.6). A box includes its
/// lower sides and excludes its upper ones. The results of adjacent boxes together form the cleaned
/// whole mesh. If rounding has to be repaired in a box, its result is cut from the cleaned whole
/// mesh. A box needs a closed oriented mesh (InputError), and cannot be combined with static_test,
/// `outermost`, `merge_flat` and `separate` (UsageError). Cost: that of the faces in and around the
/// box, and O(n log n) for the mesh.
///
/// `merge_flat` covers flat regions around cuts with as few triangles as their outlines need. Then
/// the surface moves by `merge_displacement`; sharp edges and borders of face columns stay.
#pragma once

#include <optional>

#include "transformesh/clean_result.h"
#include "transformesh/control.h"
#include "transformesh/measure.h"

namespace transformesh {

/// Search for the exterior: region growing (paper 3.2), or for closed meshes slow rays (paper 4.5).
enum class ExteriorMethod { grow, static_test };

/// Columns that state where on the input the output comes from: none, the face column source_face,
/// or source points of vertices and faces (carry.h).
enum class CleanSources { none, faces, points };

struct CleanOptions {
  ExteriorMethod method = ExteriorMethod::grow;
  int winding_level = 1;                ///< 1 gives the union, 2 the intersection of two operands
  bool outermost = false;               ///< drop cavities, and components inside them
  bool merge_flat = false;              ///< merge coplanar faces around cuts
  bool refuse = false;                  ///< throw GoalError instead of changing anything
  Scalar coordinate = Scalar::float64;  ///< type to which positions of input and output are rounded
  double separate = 0;  ///< move duplicates of a vertex apart by this; input units; 0: not at all
  CleanSources sources = CleanSources::none;
  std::optional<Box> box = {};  ///< clean only the faces in this box
  bool only = false;            ///< if `box` is set: leave out faces that do not belong to it
};

/// Cleans a mesh.
CleanResult clean(const Mesh& mesh, const CleanOptions& options = {},
                  const Progress& progress = Progress());

}  // namespace transformesh
