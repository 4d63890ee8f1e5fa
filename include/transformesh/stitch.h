/// Stitches a soup of triangles into a mesh (paper 3.3). Merges equal positions, then duplicates
/// every vertex at which the faces form more than one umbrella. Singular vertices, edges and
/// triangles thus come apart. The result is a manifold, with borders where faces have no partner.
/// At a singular edge, faces are paired across the inside, behind both faces, in exact angular
/// order. If duplicates of its ends cannot separate a singular edge, it is split in the middle.
/// References: the paper, 3.3; Gueziec, Taubin, Lazarus & Horn, "Cutting and stitching", TVCG 2001.
///
/// The first vertex of each position survives, with its columns. Faces keep their order, and pieces
/// of split faces follow. Faces with two corners at one position are dropped. Faces that traverse
/// an edge in the same direction stay apart there, unless `orient` reverses some (orient.h). Throws
/// InputError, naming the place, if a surface to be oriented is not orientable. Normals and texture
/// coordinates follow reversed faces (surface_columns.h). Cost: O(n log n). Deterministic.
#pragma once

#include <string>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct StitchOptions {
  /// Join positions within this distance, and split border edges at border vertices within it;
  /// input units; 0: join equal positions only.
  double tolerance = 0;
  /// Reverse faces so that neighbors agree. Then orient changed closed parts outwards. Changed open
  /// parts get the orientation that most of their faces had.
  bool orient = false;
  /// Drop all but the first of coincident faces of one direction; with `orient`, all of a wall.
  bool drop_copies = false;
  /// Drop faces whose reverse is present (double_sided.h), orient, and turn closed parts outwards.
  bool one_side = false;
  /// Reverse closed bodies that are inside out, with their cavities. With `orient`, a changed
  /// component first gets the orientation of most of its faces. With `one_side`, nested components
  /// are oriented outwards and inwards in turn.
  bool outwards = false;
  bool flip = false;  ///< reverse all faces, at the end
};

struct StitchResult {
  std::size_t joined_vertices = 0;  ///< positions that more than one input vertex had
  std::size_t copied_vertices = 0;  ///< duplicates made at singular vertices, edges and triangles
  std::size_t split_borders = 0;    ///< border edges split by `tolerance` at vertices near them
  std::size_t split_edges = 0;      ///< singular edges split in the middle
  std::size_t dropped_faces = 0;
  std::size_t dropped_copies = 0;  ///< faces that `drop_copies` dropped
  /// Coincident faces of opposite orientation dropped by `one_side`.
  std::size_t dropped_reverses = 0;
  std::size_t reversed_faces = 0;  ///< faces reversed by `orient`, `one_side` or `outwards`
  /// Edges that several faces without an opposite face traverse in the same direction.
  std::size_t misoriented_edges = 0;
  std::size_t border_edges = 0;  ///< edges at which one face has no partner
  bool new_normals = false;      ///< normals were recomputed after `orient` or `one_side`
  std::string misorientation;    ///< message about the first misoriented edge: faces and place
  bool can_be_oriented = false;  ///< there are misoriented edges, and `orient` would remove them
};

StitchResult stitch(Mesh& mesh, const StitchOptions& options = {});

}  // namespace transformesh
