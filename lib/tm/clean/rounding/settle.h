/// The mesh as it will be written: rounds the new vertices of a pass and repairs what rounding
/// broke, until no face crosses another or has no area in the coordinates as stored.
///
/// Each round unites what is all but one near the broken faces, by at most a few spacings of
/// numbers (unite_close.h), and cleans again. Where hundreds of faces pass one place, the points of
/// a crowd there (crowds.h) become one, however wide it is, and new vertices that are close merge,
/// over up to 256 spacings where less failed. Where that does not settle, all starts over, and the
/// places that stayed broken are treated by other distances, each on its own (trouble_spots.h).
/// Where the input is so close to degenerate that none settles a place, the vertices of the input
/// there go to a grid that is coarser with every further start: what the grid leaves apart is far
/// apart by the measure of rounding. Old vertices move in no other case. Deterministic. Throws
/// GoalError, with the place, when the coarsest grid does not help.
#pragma once

#include "tm/clean/pass/clean_pass.h"

namespace transformesh {

struct SettleOptions {
  int level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  bool is_open = false;  ///< the mesh has borders: a result is one only if it cleans to itself
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

struct Settled {
  Mesh mesh;
  std::size_t new_vertices = 0;
  std::size_t copied_vertices = 0;
  std::size_t cut_faces = 0;      ///< input faces that were whole after `pass` and are cut now
  std::size_t removed_faces = 0;  ///< and those that are gone now
  std::size_t repairs = 0;        ///< rounds of cleaning after rounding
  std::size_t grid_steps = 0;     ///< how often input vertices went to a coarser grid
};

/// `pass` is that of the mesh, and is not unchanged.
Settled settle(const Mesh& mesh, CleanPass pass, const SettleOptions& options,
               const Progress& progress);

}  // namespace transformesh
