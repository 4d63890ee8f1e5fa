/// Cleans what is in a box, and nothing else (paper 4.6): self-intersections of a very large mesh
/// are resolved where they are, or box by box in processes of their own. A face belongs to the box
/// that its first vertex is in, where a box has its lower sides and not its upper ones: boxes side
/// by side share no face and leave none out. Winding numbers are those of the whole mesh.
///
/// Faces of the box become their pieces that clean() would keep; all others keep their vertices,
/// columns and order, also where they cross what is in the box. With `only`, these pieces alone are
/// the result, made a part of the box at a time: vertices at seams are double, stitch() joins
/// them.
///
/// Guaranteed: where rounding breaks nothing in any of the boxes that a mesh is cut into, together
/// their pieces are the triangles of clean(), coordinate by coordinate. Where it does, the box is
/// taken from the result of clean() of the whole mesh (`is_whole`); its neighbors can differ from
/// that by what was mended beyond two rings of faces from there. Deterministic for any number of
/// threads.
///
/// Throws UsageError (a box without inside), InputError (the mesh has borders or is not oriented,
/// as decided by a hash of its edges), GoalError as clean() does. Cost: O(n log n) for the mesh and
/// that of clean() for what is in and around the box; beside the mesh about 5 bytes a face, and
/// 300 for each in and around the box, with `only` for 65536 and those around. That is a box too:
/// large faces there make it large.
#pragma once

#include "transformesh/clean.h"
#include "transformesh/measure.h"

namespace transformesh {

struct CleanBoxOptions {
  Box box;
  bool only = false;      ///< leave out what does not belong to the box; may leave nothing
  int winding_level = 1;  ///< as in CleanOptions
  bool refuse = false;    ///< throw rather than change anything in the box
  Scalar coordinate = Scalar::float64;
};

struct CleanBoxResult {
  CleanResult clean;          ///< counts are those of the box's faces; `changed` is of these too
  std::size_t box_faces = 0;  ///< that belong to the box
  bool is_whole = false;      ///< rounding broke faces there, so the whole mesh was cleaned
};

CleanBoxResult clean_box(const Mesh& mesh, const CleanBoxOptions& options,
                         const Progress& progress = Progress());

}  // namespace transformesh
