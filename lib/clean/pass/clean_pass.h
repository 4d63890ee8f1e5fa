/// One clean pass of TransforMesh (paper 3, Fig. 3): weld, intersect (3.1), arrange (3.2.3), find
/// the exterior (3.2), stitch (3.3). Of a closed mesh only what is exterior is arranged, unless all
/// is asked for. Exact but for the positions of new vertices, which are in doubles. Throws as
/// clean.h says.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "clean/exterior/exterior.h"
#include "clean/stitch/assemble.h"
#include "transformesh/components.h"
#include "transformesh/control.h"

namespace transformesh {

struct CleanPass {
  std::size_t pairs = 0;  ///< intersecting face pairs; where they are too many, all else is empty
  std::size_t cut_faces = 0;      ///< faces that were cut
  std::size_t removed_faces = 0;  ///< whole faces that were dropped
  Exterior exterior;
  bool is_open = false;  ///< the mesh has borders
  bool unchanged = false;
  /// Of a mesh that is a closed manifold, in which nothing meets and all is exterior.
  std::optional<Connectivity> connectivity;
  Assembly assembly;  ///< empty where unchanged
};

struct CleanPassOptions {
  int winding_level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  bool check_orientation = true;  ///< refuse a mesh that is not oriented
  /// Changes which pieces are kept, before these are stitched.
  std::function<void(Arrangement& arrangement, std::vector<char>& kept)> change_kept{};
  /// The clean pass ends if more pairs intersect.
  std::size_t most_pairs = std::numeric_limits<std::size_t>::max();
};

CleanPass run_clean_pass(const Mesh& mesh, const CleanPassOptions& options,
                         const Progress& progress);

}  // namespace transformesh
