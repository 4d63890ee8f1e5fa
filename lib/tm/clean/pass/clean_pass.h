/// One pass of TransforMesh (paper 3): intersect, arrange, find the exterior, stitch. Exact but for
/// the positions of new vertices, which are in doubles. Throws as clean.h says.
#pragma once

#include <limits>

#include "tm/clean/exterior/exterior.h"
#include "tm/clean/stitch/assemble.h"
#include "tm/mesh/mesh.h"
#include "tm/support/progress.h"

namespace transformesh {

struct CleanPass {
  std::size_t pairs = 0;          ///< intersecting face pairs; all there is, where that is too many
  std::size_t cut_faces = 0;      ///< faces that were cut
  std::size_t removed_faces = 0;  ///< whole faces that were dropped
  Exterior exterior;
  bool is_open = false;  ///< the mesh has borders
  bool unchanged = false;
  Assembly assembly;  ///< empty where unchanged
};

struct PassOptions {
  int level = 1;
  ExteriorMethod method = ExteriorMethod::grow;
  bool check_orientation = true;  ///< refuse a mesh that is not oriented
  std::size_t most_pairs = std::numeric_limits<std::size_t>::max();  ///< more are too many
};

CleanPass run_clean_pass(const Mesh& mesh, const PassOptions& options, const Progress& progress);

}  // namespace transformesh
