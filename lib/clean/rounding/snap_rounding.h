/// Snap rounding: the mesh as it will be written (paper 4.3). Rounds the new vertices of a clean
/// pass, and repairs what rounding broke, until no face intersects another or has no area in the
/// coordinates as stored.
///
/// Every new vertex takes the nearest numbers, or the position of a vertex less than a spacing
/// away. That is all where nothing breaks. Around broken faces, in rounds: close vertices merge
/// (close_vertices.h), slivers are flipped away (slivers.h), thin sheets come apart
/// (push_outwards.h), what intersects barely comes to share corners (contact_splits.h), and the
/// surface is cleaned again, where cells too thin to matter go to the side that leaves less surface
/// (thin_cells.h). What counts as close and thin is 3 and 4 spacings at first, and grows by 2^(1/4)
/// and 2^(1/2) from round to round. Spacings are those at the largest coordinate of a vertex; where
/// a mesh reaches 2^40 times farther than half of its vertices, those along each axis
/// (local_distance.h). Where two rounds in a row leave no fewer faces broken, all starts over,
/// three rounds ahead; the first three times from the input's exact arrangement, in which cells
/// beside the broken faces are given away that are thinner than 256, 2048 and 16384 spacings:
/// sheets that intersect at tiny angles would be crossed anew by every rounding. Where rounding
/// breaks more than a third of the faces, the last starts, and of a mesh that reaches far already
/// the second, first put all vertices on their own grids (vertex_grids.h), within .87 spacings,
/// then 32 times coarser from start to start. (Not so open meshes, and those whose faces meet more
/// than 60 others on average: their arrangement is too large.)
///
/// Guaranteed: the result has no self-intersection. All that moves or goes is within `displacement`
/// of where it was, so winding numbers farther than that from the surface are those of the input (a
/// homotopy that does not meet a point keeps its winding number). Nothing moves that takes no part
/// in an intersection, but around broken faces, and to own grids. That repair ends well is
/// measured, not proven; its work is bounded by a multiple of that of the first clean pass.
/// Deterministic. References: Halperin & Packer, "Iterated snap rounding", Computational Geometry
/// 23(2), 2002; Valque & Lazard, "Removing self-intersections in 3D meshes while preserving
/// floating-point coordinates", 2025, where every round snaps to one grid.
#pragma once

#include "clean/pass/clean_pass.h"
#include "clean/rounding/displacement.h"
#include "clean/rounding/local_distance.h"

namespace transformesh {

struct SnapRoundingOptions {
  int winding_level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  bool is_open = false;                 ///< the mesh has borders: its cells are unknown
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

struct SnapRoundingResult {
  Mesh mesh;
  std::size_t new_vertices = 0;
  std::size_t copied_vertices = 0;
  std::size_t cut_faces = 0;      ///< input faces that were whole after `pass` and are cut now
  std::size_t removed_faces = 0;  ///< input faces that were whole after `pass` and are gone now
  std::size_t repairs = 0;        ///< rounds of repair
  std::size_t places = 0;         ///< where rounding broke faces
  Displacement displacement;
};

/// The first round alone: rounds the new vertices of an assembly, as those of every mesh are, and
/// says in how many places that breaks faces. Spacings are those for the whole mesh. Where it
/// breaks none this is what snap_round() does, also of a part of that mesh: no vertex depends on
/// others that are farther than a few spacings.
struct FirstRound {
  std::size_t places = 0;
  Displacement displacement;
};
FirstRound round_once(Assembly& assembly, const Spacings& spacings);

/// `pass` is that of the mesh, and is not unchanged. Throws GoalError, with the place, where repair
/// does not end, and where nothing is left that is thicker than rounding moves it.
SnapRoundingResult snap_round(const Mesh& mesh, const CleanPass& pass,
                              const SnapRoundingOptions& options, const Progress& progress);

}  // namespace transformesh
