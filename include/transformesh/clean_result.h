/// Result of clean(): the mesh, and counts of what was found and changed. With a `box`, all counts
/// are of the faces that belong to the box.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transformesh/components.h"

namespace transformesh {

struct CleanResult {
  Mesh mesh;
  bool changed = false;
  std::size_t pairs = 0, pieces = 0;                  ///< intersecting face pairs; faces once cut
  std::size_t cut_faces = 0, removed_faces = 0;       ///< input faces that were cut; dropped whole
  std::size_t new_vertices = 0, copied_vertices = 0;  ///< copies are made at singular vertices and
                                                      ///< edges
  std::size_t patches = 0, rays = 0;                  ///< parts of a mesh with borders; rays cast
  std::size_t decided_by_number = 0;   ///< patches that a generalized winding number decided
  double least_margin = 0.5;           ///< least distance of such a number from rounding otherwise
  std::size_t dropped_components = 0;  ///< because of `outermost`
  std::size_t rounding_repairs = 0, rounding_places = 0;  ///< rounds and places of repair
  std::size_t rounding_faces = 0, rounding_pairs = 0;     ///< in all rounds: broken, intersecting
  std::size_t rounding_level = 0;                         ///< doublings of a grid
  double rounding_displacement = 0;  ///< largest distance that rounding moved a vertex; input units
  double rounding_spacings = 0;      ///< largest such distance in coordinate spacings there
  std::size_t merged_faces = 0;      ///< faces that `merge_flat` saved
  std::size_t merge_refused = 0;     ///< flat regions left as they were to avoid intersections
  double merge_displacement = 0;     ///< bound on the movement by `merge_flat`; input units
  std::size_t separated_vertices = 0;          ///< vertices that `separate` moved
  std::size_t separation_refused = 0;          ///< vertices that still have a copy in their place
  std::size_t box_faces = 0;                   ///< faces that belong to the box
  bool is_whole = false;                       ///< the whole mesh was cleaned to repair rounding
  std::vector<std::string> dropped_columns{};  ///< texture coordinates of faces that were cut
  bool dropped_source_points = false;          ///< source points of the input are gone (carry.h)
  std::optional<Connectivity> connectivity{};  ///< set if nothing was changed
};

}  // namespace transformesh
