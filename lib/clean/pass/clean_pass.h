/// One clean pass of TransforMesh (paper 3, Fig. 3): weld, intersect (3.1), find the exterior and
/// arrange it (3.2), stitch (3.3). Exact but for the positions of new vertices, which are in
/// doubles, and for patches of open components that generalized winding numbers decide
/// (open/open_patches.h). Throws as clean.h says.
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

namespace transformesh {

struct CleanPass {
  std::size_t pairs = 0;   ///< intersecting face pairs; where they are too many, all else is empty
  std::size_t pieces = 0;  ///< in the arrangement; hidden ones may be left out
  std::size_t cut_faces = 0;          ///< faces that were cut
  std::size_t removed_faces = 0;      ///< whole faces that were dropped
  bool is_open = false;               ///< the mesh has borders
  std::size_t rays = 0;               ///< that were cast to find winding numbers
  std::size_t open_patches = 0;       ///< patches of a mesh with open components
  std::size_t decided_by_number = 0;  ///< patches that a generalized winding number decided
  double least_margin = 0.5;  ///< how close such a number came to where it would round otherwise
  bool unchanged = false;
  /// Of a mesh that is a closed manifold, in which nothing meets and all is exterior.
  std::optional<Connectivity> connectivity;
  Assembly assembly;  ///< empty where unchanged
};

struct CleanPassOptions {
  int winding_level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  bool check_orientation = true;          ///< refuse a mesh that is not oriented
  const PieceChooser* chooser = nullptr;  ///< null: the winding level alone decides
  /// Changes which pieces of a closed mesh are kept, before these are stitched.
  std::function<void(Arrangement& arrangement, std::vector<char>& kept)> change_kept{};
  /// The clean pass ends if more pairs intersect.
  std::size_t most_pairs = std::numeric_limits<std::size_t>::max();
};

CleanPass run_clean_pass(const Mesh& mesh, const CleanPassOptions& options,
                         const Progress& progress);

}  // namespace transformesh
