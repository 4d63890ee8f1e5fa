/// Result of clean(): the mesh, and counts of what was found and changed. With CleanOptions::box,
/// all counts refer to faces that belong to the box.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transformesh/components.h"

namespace transformesh {

struct CleanResult {
  Mesh mesh;
  bool changed = false;
  /// Intersecting pairs of faces; number of faces after cutting.
  std::size_t pairs = 0, pieces = 0;
  /// Input faces that were cut; input faces that were dropped whole.
  std::size_t cut_faces = 0, removed_faces = 0;
  /// Vertices made on intersections; duplicates made where parts of the surface touch.
  std::size_t new_vertices = 0, copied_vertices = 0;
  /// Patches: parts of an open mesh between intersection curves; 0 for closed meshes. Rays: cast to
  /// find the exterior.
  std::size_t patches = 0, rays = 0;
  std::size_t decided_by_number = 0;  ///< patches decided by their generalized winding number
  /// Least distance of a generalized winding number from the half-integers, where its rounding
  /// changes.
  double least_margin = 0.5;
  std::size_t dropped_components = 0;  ///< components that `outermost` dropped
  /// Rounds of repair; places repaired in them.
  std::size_t rounding_repairs = 0, rounding_places = 0;
  /// Faces broken by rounding and intersecting pairs of faces, each summed over all rounds of
  /// repair.
  std::size_t rounding_faces = 0, rounding_pairs = 0;
  std::size_t rounding_level = 0;  ///< largest number of times that a rounding grid was coarsened
  /// Bounds on the movement of the surface by rounding and repair: in input units, and in multiples
  /// of the floating-point spacing at the coordinates.
  double rounding_displacement = 0;
  double rounding_spacings = 0;
  std::size_t merged_faces = 0;   ///< faces by which `merge_flat` reduced the mesh
  std::size_t merge_refused = 0;  ///< flat regions that were not merged, to avoid intersections
  double merge_displacement = 0;  ///< bound on the movement by `merge_flat`; input units
  std::size_t separated_vertices = 0;  ///< vertices that `separate` moved apart from a duplicate
  std::size_t separation_refused = 0;  ///< vertices that still coincide with a duplicate
  std::size_t box_faces = 0;           ///< faces that belong to the box
  bool is_whole = false;               ///< the whole mesh was cleaned to repair rounding
  std::vector<std::string> dropped_columns{};  ///< dropped texture coordinates, if faces were cut
  /// Source points of the input were dropped (carry.h).
  bool dropped_source_points = false;
  /// Connectivity of the mesh; set only if nothing was changed.
  std::optional<Connectivity> connectivity{};
};

}  // namespace transformesh
