/// One clean pass of TransforMesh (paper 3, Fig. 3): weld, intersect (3.1), find the exterior and
/// arrange it (3.2), stitch (3.3). Exact, with two exceptions. Positions of new vertices are
/// rounded to doubles. In an open mesh, generalized winding numbers decide whether some parts of
/// the surface are kept (open/open_patches.h). Throws what clean() throws. Cost: O(n log n) plus
/// that of the arrangement.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "clean/arrange/arrange.h"
#include "clean/pass/piece_chooser.h"
#include "clean/stitch/assemble.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/intersect.h"

namespace transformesh {

struct CleanPass {
  /// Number of intersecting pairs of faces. If it exceeds `most_pairs`, all other members are
  /// empty.
  std::size_t pairs = 0;
  /// Number of pieces of cut and whole faces; hidden pieces may be missing.
  std::size_t pieces = 0;
  std::size_t cut_faces = 0;
  std::size_t removed_faces = 0;  ///< number of faces without intersections that were removed
  bool is_open = false;           ///< true if the mesh has borders
  std::size_t rays = 0;           ///< number of rays cast to find winding numbers
  /// Number of patches (connected pieces), if the mesh has open components.
  std::size_t open_patches = 0;
  /// Number of patches that needed a generalized winding number.
  std::size_t decided_by_number = 0;
  /// Least distance of a used generalized winding number from the nearest value at which it would
  /// be rounded to another integer.
  double least_margin = 0.5;
  bool unchanged = false;
  /// Connectivity of the mesh. Set only if the mesh is a closed manifold without intersections, and
  /// all its faces are exterior.
  std::optional<Connectivity> connectivity;
  Assembly assembly;  ///< the result; empty if `unchanged` is set
};

/// The arrangement of a mesh, and the pieces that a clean pass keeps before `change_kept`.
struct ArrangedMesh {
  Arrangement arrangement;
  std::vector<char> kept;
  std::size_t whole_faces = 0;
};

struct CleanPassOptions {
  int winding_level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  bool check_orientation = true;  ///< throw if the mesh is not oriented
  /// Selects the pieces that are kept. If null, the winding level alone decides.
  const PieceChooser* chooser = nullptr;
  /// Function that changes which pieces of a closed mesh are kept; called before stitching.
  std::function<void(Arrangement& arrangement, std::vector<char>& kept)> change_kept{};
  /// The clean pass ends early if more pairs of faces than this intersect.
  std::size_t most_pairs = std::numeric_limits<std::size_t>::max();
  /// All intersecting pairs of faces of the mesh. If null, the clean pass finds them.
  const std::vector<FacePair>* pairs = nullptr;
  /// Taken instead of arranging the mesh, unless it is empty; filled otherwise. Clean passes that
  /// share it must differ only in `change_kept`, which must be set. May be null.
  ArrangedMesh* arranged = nullptr;
  /// Number type of the input, in which the result will be stored after the clean pass.
  Scalar coordinate = Scalar::float64;
};

CleanPass run_clean_pass(const Mesh& mesh, const CleanPassOptions& options,
                         const Progress& progress);

}  // namespace transformesh
