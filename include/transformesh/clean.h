/// TransforMesh (paper 3): the boundary of { p : w(p) >= winding level } of a closed oriented mesh,
/// w being the winding number, as a closed 2-manifold that is oriented outwards. Level 1 removes
/// every self-intersection, inverted region and overlap; surfaces merge, split, open and close.
///
/// Guarantees: every output face is an input face or a piece of one. Faces without intersection
/// keep coordinates, columns and order, except beside faces that rounding breaks. A manifold with
/// nothing to clean is unchanged. Equal positions are one point. Rounded to `coordinate`, the
/// output has no self-intersection (coincident vertices and edges may touch) and no face without
/// area. In a mesh with borders, the closed part is cleaned as if it were alone. Open components
/// lose what lies inside of it and what another one has behind it along a curve
/// (docs/design/open-meshes.md). Throws InputError if the mesh is not oriented, and UsageError for
/// static_test on an open mesh. Throws GoalError if no point reaches the level, if rounding cannot
/// be repaired, or if `refuse` forbids a change. Deterministic. Cost: O(n log n + k log k).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transformesh/components.h"
#include "transformesh/control.h"

namespace transformesh {

/// Region growing (paper 3.2), or rays as a slow reference for closed meshes (paper 4.5).
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
  std::size_t pairs = 0, pieces = 0;                  ///< intersecting face pairs; faces once cut
  std::size_t cut_faces = 0, removed_faces = 0;       ///< input faces: cut; dropped as a whole
  std::size_t new_vertices = 0, copied_vertices = 0;  ///< copies are for singular places
  std::size_t patches = 0, rays = 0;                  ///< parts of a mesh with borders; rays cast
  std::size_t decided_by_number = 0;  ///< patches that a generalized winding number decided
  double least_margin = 0.5;  ///< the distance of such a number to where it rounds otherwise
  std::size_t dropped_components = 0;                     ///< by `outermost`
  std::size_t rounding_repairs = 0, rounding_places = 0;  ///< rounds and places of repair
  std::size_t rounding_faces = 0, rounding_pairs = 0;     ///< in all rounds: broken, intersecting
  std::size_t rounding_level = 0;                         ///< doublings of a grid
  double rounding_displacement = 0;          ///< largest distance by which rounding moved a vertex
  double rounding_spacings = 0;              ///< the same in spacings of the coordinates there
  std::vector<std::string> dropped_columns;  ///< texture coordinates of faces that were cut
  bool dropped_source_points = false;        ///< carry.h
  std::optional<Connectivity> connectivity;  ///< set if there was nothing to change
};

/// Cleans a mesh.
CleanResult clean(const Mesh& mesh, const CleanOptions& options = {},
                  const Progress& progress = Progress());

}  // namespace transformesh
