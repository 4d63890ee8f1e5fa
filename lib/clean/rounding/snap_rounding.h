/// Snap rounding: computes the mesh with the coordinates that will be written (paper 4.3). Rounds
/// the new vertices of a clean pass (pass/clean_pass.h), and repairs broken faces, which intersect
/// others or have no area after rounding. The result has no broken faces, in the coordinates as
/// written.
///
/// Each coordinate of a new vertex is rounded to the nearest number. If exact tests find no broken
/// face, the mesh is the result. Otherwise it is repaired in rounds. Each vertex has a grid, whose
/// step is half the spacing of floating-point numbers at the vertex. The step doubles at the
/// corners of broken faces (vertex_grids.h). A round has these steps, until no face is broken:
///
/// 1. Vertices around broken faces move to their grids.
/// 2. Edges shorter than two steps are collapsed, and vertices are removed if the surface around
///    them is flat within four steps (flat_vertices.h).
/// 3. Slivers lower than four steps are flipped (slivers.h).
///
/// From the second round on, these steps also move vertices of the input. Then the surface is
/// cleaned again, and thin cells are assigned to the side that leaves less surface (thin_cells.h).
/// If a round does not reduce the number of broken faces, repair restarts once, from the exact
/// arrangement of the input. After the restart, grids at the faces that broke are 8 times coarser,
/// thin cells at these faces are removed before rounding, and vertices do not move to their grids.
/// Later rounds make grids 8 times coarser if they do not reduce the number of broken faces,
/// otherwise twice as coarse. If repair fails after 16 rounds, it restarts once more and moves
/// vertices to their grids. The reasons are in docs/design/rounding.md.
///
/// Guarantees: the result has no self-intersections. Each point moves by at most `displacement`.
/// Hence the winding number at a point farther than this from the surface is that of the input. The
/// reason is that a deformation changes winding numbers only at points over which the surface
/// passes. Faces that take no part in an intersection do not move, except near broken faces. The
/// algorithm terminates: it throws after at most 32 rounds, or if the number of intersecting pairs
/// exceeds four times the pairs and faces of the input. Deterministic. Cost: that of at most 32
/// clean passes.
///
/// References: Halperin & Packer, "Iterated snap rounding", Computational Geometry 23(2), 2002;
/// Valque & Lazard, "Removing self-intersections in 3D meshes while preserving floating-point
/// coordinates", 2025. In Valque & Lazard, each round snaps all vertices to one grid.
#pragma once

#include "clean/pass/clean_pass.h"
#include "clean/rounding/displacement.h"

namespace transformesh {

struct SnapRoundingOptions {
  int winding_level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  /// True if the mesh has borders. Then thin cells of space are not removed, and repair does not
  /// restart, because it is not known which cells are inside.
  bool is_open = false;
  Scalar coordinate = Scalar::float64;  ///< type in which positions will be written
  /// Selects the pieces (triangles of the arrangement) that the clean pass kept.
  const PieceChooser* chooser = nullptr;
};

struct SnapRoundingResult {
  Mesh mesh;
  /// 1 for each face that is new or was cut; 0 for each face that equals an input face.
  std::vector<char> face_is_new;
  /// For each face: the input face that is equal to it, or from which it is cut.
  std::vector<Index> source_face;
  std::size_t new_vertices = 0;
  std::size_t copied_vertices = 0;
  /// Number of input faces that rounding or repair cut, but the clean pass did not.
  std::size_t cut_faces = 0;
  /// Number of input faces that rounding or repair removed, but the clean pass did not.
  std::size_t removed_faces = 0;
  std::size_t repairs = 0;  ///< number of repair rounds
  /// Number of connected sets of faces that were broken after the first rounding.
  std::size_t places = 0;
  std::size_t faces = 0;  ///< number of broken faces, summed over all repair rounds
  std::size_t pairs = 0;  ///< number of intersecting pairs, summed over all repair rounds
  unsigned level = 0;     ///< largest number of times that the grid step of a vertex was doubled
  Displacement displacement;
};

/// Result of round_once(), which rounds the new vertices of a mesh without repair. `places` is the
/// number of connected sets of broken faces. If it is 0, snap_round() would return the rounded
/// mesh. This also holds if the assembly contains only a part of a mesh.
struct FirstRound {
  std::size_t places = 0;
  Displacement displacement;
};
FirstRound round_once(Assembly& assembly, Scalar type);

/// Rounds the new vertices of the result of `pass`, which is a clean pass of `mesh` that changed
/// something. Throws GoalError if repair does not succeed; the error gives the location of a broken
/// face. Also throws GoalError if everything that the mesh encloses is thinner than the
/// displacement by rounding.
SnapRoundingResult snap_round(const Mesh& mesh, const CleanPass& pass,
                              const SnapRoundingOptions& options, const Progress& progress);

}  // namespace transformesh
