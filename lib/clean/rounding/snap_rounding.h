/// Snap rounding: the mesh as it will be written (paper 4.3). Rounds the new vertices of a clean
/// pass, and repairs what rounding broke, until no face intersects another or has no area in the
/// coordinates as stored.
///
/// Every new vertex takes the nearest numbers. That is all where exact tests find no broken face.
/// Else, in rounds: each vertex has a grid, whose step is half the spacing of numbers at it, and
/// doubles at the corners of broken faces (vertex_grids.h). Around these, vertices move to their
/// grids, until repair begins anew. Edges shorter than two steps are collapsed, and vertices around
/// which the surface is flat to four steps go (flat_vertices.h). Slivers that low are flipped away
/// (slivers.h). Vertices of the input take part from the second round on. Then the surface is
/// cleaned again, where cells that thin go to the side that leaves less surface (thin_cells.h). If
/// a round leaves no fewer faces broken than the one before, repair begins anew, once, from the
/// exact arrangement of the input. Then grids are 8 times coarser at the faces that broke, and thin
/// cells beside them are given away before anything is rounded. docs/design/rounding.md has the
/// reasons for each step.
///
/// Guaranteed: the result has no self-intersection. All that moves or goes is within `displacement`
/// of where it was, so winding numbers farther than that from the surface are those of the input (a
/// homotopy that does not meet a point keeps its winding number). Nothing moves that takes no part
/// in an intersection, but around broken faces. It ends: after 16 rounds, or where more pairs
/// intersect than four times the pairs and faces of the input, it throws. Deterministic.
/// References: Halperin & Packer, "Iterated snap rounding", Computational Geometry 23(2), 2002;
/// Valque & Lazard, "Removing self-intersections in 3D meshes while preserving floating-point
/// coordinates", 2025, where every round snaps to one grid.
#pragma once

#include "clean/pass/clean_pass.h"
#include "clean/rounding/displacement.h"

namespace transformesh {

struct SnapRoundingOptions {
  int winding_level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  bool is_open = false;                   ///< the mesh has borders: its cells are unknown
  Scalar coordinate = Scalar::float64;    ///< the type in which positions will be written
  const PieceChooser* chooser = nullptr;  ///< that of `pass`
};

struct SnapRoundingResult {
  Mesh mesh;
  std::vector<char> face_is_new;   ///< per face: not a whole face of the input
  std::vector<Index> source_face;  ///< per face: the input face that it is, or is cut from
  std::size_t new_vertices = 0;
  std::size_t copied_vertices = 0;
  std::size_t cut_faces = 0;      ///< input faces that were whole after `pass` and are cut now
  std::size_t removed_faces = 0;  ///< input faces that were whole after `pass` and are gone now
  std::size_t repairs = 0;        ///< rounds of repair
  std::size_t places = 0;         ///< where rounding broke faces
  std::size_t faces = 0;          ///< that were broken, in all rounds of repair
  std::size_t pairs = 0;          ///< that intersected, in all rounds of repair
  unsigned level = 0;             ///< how often the step of a grid was doubled at most
  Displacement displacement;
};

/// The first round alone: rounds the new vertices of an assembly, and says in how many places that
/// breaks faces. Where it breaks none this is what snap_round() does, also of a part of that mesh.
struct FirstRound {
  std::size_t places = 0;
  Displacement displacement;
};
FirstRound round_once(Assembly& assembly, Scalar type);

/// `pass` is that of the mesh, and is not unchanged. Throws GoalError, with the place, where repair
/// does not end, and where nothing is left that is thicker than rounding moves it.
SnapRoundingResult snap_round(const Mesh& mesh, const CleanPass& pass,
                              const SnapRoundingOptions& options, const Progress& progress);

}  // namespace transformesh
