/// Splits faces along self-intersections and removes nothing: the arrangement of paper 3.2.3 as a
/// mesh. Afterwards faces meet in common vertices and edges only (up to rounding of new vertices),
/// and faces that overlapped in a plane have coincident pieces.
/// Whole faces come first, in order; then the pieces of the cut ones. Vertices keep their order,
/// new ones follow. Columns are interpolated and inherited; the face column `source_face` names the
/// input face of each piece. Faces without area are dropped. Exact but for the rounding.
#pragma once

#include "tm/clean/intersect/intersect.h"

namespace transformesh {

Mesh refine(const Mesh& mesh, const Progress& progress = Progress());

}  // namespace transformesh
