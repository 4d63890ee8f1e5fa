/// TransforMesh (paper 3): the boundary of { p : w(p) >= winding level } of a closed oriented mesh,
/// w being the winding number, as a closed 2-manifold that is oriented outwards. Level 1 removes
/// every self-intersection, inverted region and overlap; surfaces merge, split, open and close.
///
/// Guarantees: every output face is an input face or a piece of one. Faces without intersection
/// keep their coordinates (unless they are extreme), columns and order. A manifold with nothing to
/// clean is returned unchanged. Equal positions are one point. The output has no self-intersection
/// in coordinates rounded to `coordinate` (coincident vertices and edges may touch), and no face
/// without area. Exact; deterministic for any number of threads.
///
/// Of a mesh with borders, the closed part is cleaned as if it were alone. Open components lose
/// what lies inside of it, and what is behind another one along a curve in which they intersect
/// (docs/design/open-meshes.md). Generalized winding numbers decide a patch if no exact one does.
///
/// Throws InputError if the mesh is not oriented, UsageError for static_test on an open mesh,
/// GoalError if no point reaches the level, if rounding cannot be repaired, or if `refuse` forbids
/// a change. Cost: O(n log n + k log k) for k intersecting pairs on usual meshes; about 250 bytes a
/// face.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transformesh/components.h"
#include "transformesh/control.h"

namespace transformesh {

/// Region growing (paper 3.2), or a ray for each piece (paper 4.5; slow reference, closed meshes
/// only).
enum class ExteriorMethod { grow, static_test };

struct CleanOptions {
  ExteriorMethod method = ExteriorMethod::grow;
  int winding_level = 1;                ///< 1 is the union, 2 the intersection of two operands
  bool outermost = false;               ///< drop cavities, and components inside them
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
  std::size_t copied_vertices = 0;     ///< duplicates made at singular vertices and edges
  std::size_t rays = 0;                ///< cast to find winding numbers
  std::size_t patches = 0;             ///< of a mesh with borders that was cut
  std::size_t decided_by_number = 0;   ///< patches that a generalized winding number decided
  double least_margin = 0.5;           ///< distance of such a number to where it rounds otherwise
  std::size_t dropped_components = 0;  ///< by `outermost`
  std::size_t rounding_repairs = 0;    ///< rounds of repair after rounding
  std::size_t rounding_places = 0;     ///< places where rounding broke faces
  double rounding_displacement = 0;    ///< largest distance by which rounding moved a vertex
  double rounding_spacings = 0;        ///< the same in spacings of the coordinates there
  std::vector<std::string> dropped_columns;  ///< texture coordinates of faces that were cut
  bool dropped_source_points = false;        ///< carry.h
  std::optional<Connectivity> connectivity;  ///< set if there was nothing to change
};

/// Cleans a mesh.
CleanResult clean(const Mesh& mesh, const CleanOptions& options = {},
                  const Progress& progress = Progress());

}  // namespace transformesh
