#include "tm/clean/clean_pass.h"

#include <algorithm>
#include <memory>
#include <string>

#include "tm/clean/arrange.h"
#include "tm/clean/close_borders.h"
#include "tm/clean/intersect.h"
#include "tm/clean/orientation_check.h"
#include "tm/support/error.h"

namespace transformesh {

CleanPass run_clean_pass(const Mesh& mesh, const PassOptions& options, const Progress& progress) {
  CleanPass pass;
  progress("intersect");
  const auto soup = std::make_shared<const Soup>(make_soup(mesh));
  const auto [loops, is_oriented] = find_borders(*soup, mesh);
  if (options.check_orientation && !is_oriented) refuse_orientation(*soup, mesh);
  if (!loops.empty() && options.method == ExteriorMethod::static_test) {
    throw UsageError("--method static needs a closed mesh; this one has " +
                     std::to_string(loops.size()) + " borders: use --method grow");
  }
  const std::vector<FacePair> pairs = find_soup_intersections(*soup, progress);
  const Arrangement arrangement = arrange(soup, pairs, progress);
  pass.exterior = find_exterior(arrangement, options.level, options.method,
                                close_borders(*soup, loops), progress);

  const auto& kept = pass.exterior.kept;
  const auto whole_end = kept.begin() + static_cast<std::ptrdiff_t>(arrangement.whole_pieces);
  pass.pairs = pairs.size();
  pass.cut_faces = soup->faces.size() - arrangement.whole_pieces;
  pass.removed_faces = static_cast<std::size_t>(std::count(kept.begin(), whole_end, 0));
  pass.unchanged =
      pass.cut_faces == 0 && pass.removed_faces == 0 && soup->faces.size() == mesh.faces.size();
  progress("stitch");
  if (!pass.unchanged) pass.assembly = assemble(mesh, arrangement, kept);
  return pass;
}

}  // namespace transformesh
