/// Stitching a soup of triangles into a mesh (paper 3.3): equal positions become one vertex, and
/// then every vertex at which the faces form more than one umbrella is duplicated, so that singular
/// vertices, edges and triangles come apart. The result is a manifold, with borders where faces are
/// left over. At a singular edge sheets pair across the inside, behind both faces, in exact angular
/// order; an edge that copies of its ends cannot take apart is split in the middle.
/// References: the paper, 3.3; Gueziec, Taubin, Lazarus & Horn, "Cutting and stitching", TVCG 2001.
///
/// The first vertex of each position survives, with its columns. Faces keep their order, and what
/// is cut off them follows. Faces that name a position twice are dropped. Faces that run the same
/// way along an edge stay apart there, unless `orient` reverses some (orient.h). Throws InputError
/// where a surface that is to be oriented has one side only (a Moebius strip), naming the place.
/// Normals and texture coordinates follow faces that are reversed (surface_columns.h).
/// Cost: O(n log n). Deterministic.
#pragma once

#include <string>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct StitchOptions {
  /// Join positions within this distance, and split border edges at border vertices within it;
  /// input units; 0: join equal positions only.
  double tolerance = 0;
  bool orient = false;  ///< reverse faces so that neighbors agree; closed parts that needed it then
                        ///< look outwards, open ones the way most of their faces did
  /// Drop all but the first of faces that lie upon each other and have the same direction.
  bool drop_copies = false;
  bool one_side = false;  ///< drop faces whose reverse is there (double_sided.h), orient, and turn
                          ///< closed parts outwards
  /// Reverse closed bodies that are inside out, with their cavities. With `orient`, a component
  /// that needed it first looks the way most of its faces did. With `one_side`, nested components
  /// look outwards and inwards in turn.
  bool outwards = false;
  bool flip = false;  ///< reverse all faces, at the end
};

struct StitchResult {
  std::size_t joined_vertices = 0;  ///< how many positions were given more than once
  std::size_t copied_vertices = 0;  ///< duplicates made at singular vertices, edges, triangles
  std::size_t split_borders = 0;    ///< border edges split by `tolerance` at vertices near them
  std::size_t split_edges = 0;      ///< singular edges split in the middle
  std::size_t dropped_faces = 0;
  std::size_t dropped_copies = 0;     ///< faces that `drop_copies` dropped
  std::size_t dropped_reverses = 0;   ///< by `one_side`
  std::size_t reversed_faces = 0;     ///< because of `orient`, `one_side`, `outwards`
  std::size_t misoriented_edges = 0;  ///< edges at which several are, in the same direction
  std::size_t border_edges = 0;       ///< edges at which one face is left over
  bool new_normals = false;           ///< of a surface that `orient` or `one_side` turned
  std::string misorientation;         ///< the first misoriented edge in words: faces and place
  bool can_be_oriented = false;       ///< `orient` would leave no misoriented edge, where there are
};

StitchResult stitch(Mesh& mesh, const StitchOptions& options = {});

}  // namespace transformesh
