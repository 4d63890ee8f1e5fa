/// Snap rounding: the mesh as it will be written (paper 4.3). Rounds the new vertices of a pass,
/// and repairs what rounding broke, until no face crosses another or has no area in the coordinates
/// as stored.
///
/// Each round unites parts near the broken faces that are a few spacings of numbers apart at most
/// (unite_close.h), and cleans again. Where hundreds of faces pass one place, the points of a
/// cluster there (clusters.h) become one, however wide it is, and new vertices merge that are
/// close, up to 256 spacings where less failed. Where rounds do not end with a mesh that is whole,
/// all starts over, and each place that stayed broken is treated by other distances
/// (trouble_spots.h). Where none of these helps, as the input is nearly degenerate there, its
/// vertices go to a grid, which is coarser with every further start: what a grid leaves apart is
/// far apart by the measure of rounding. Input vertices move in no other case. Deterministic.
/// References: Halperin & Packer, "Iterated snap rounding", Computational Geometry 23(2), 2002, for
/// segments in the plane; Valque & Lazard, "Removing self-intersections in 3D meshes while
/// preserving floating-point coordinates", 2025, where every round snaps to one grid.
#pragma once

#include "tm/clean/pass/clean_pass.h"

namespace transformesh {

struct SnapRoundingOptions {
  int level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  bool is_open = false;  ///< the mesh has borders; then a result must also clean to itself
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

struct SnapRoundingResult {
  Mesh mesh;
  std::size_t new_vertices = 0;
  std::size_t copied_vertices = 0;
  std::size_t cut_faces = 0;      ///< input faces that were whole after `pass` and are cut now
  std::size_t removed_faces = 0;  ///< input faces that were whole after `pass` and are gone now
  std::size_t repairs = 0;        ///< rounds of cleaning after rounding
  std::size_t grid_steps = 0;     ///< how often input vertices went to a coarser grid
};

/// `pass` is that of the mesh, and is not unchanged. Throws GoalError, with the place, where the
/// coarsest grid does not help.
SnapRoundingResult snap_round(const Mesh& mesh, CleanPass pass, const SnapRoundingOptions& options,
                              const Progress& progress);

}  // namespace transformesh
