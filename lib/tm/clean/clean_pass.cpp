#include "tm/clean/clean_pass.h"

#include <algorithm>
#include <memory>
#include <string>

#include "tm/clean/arrange.h"
#include "tm/clean/close_borders.h"
#include "tm/clean/intersect.h"
#include "tm/clean/orientation_check.h"
#include "tm/mesh/manifold.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

// Whether indices say what positions say: a soup, a seam or a singular vertex is to be stitched.
bool is_stitched(const Mesh& mesh, const Borders& borders) {
  const ManifoldReport report = check_manifold(mesh);
  std::size_t border_edges = 0;
  for (const auto& loop : borders.loops) border_edges += loop.size();
  return report.is_manifold() && report.is_oriented() &&
         report.border_halfedges.size() == border_edges;
}

}  // namespace

CleanPass run_clean_pass(const Mesh& mesh, const PassOptions& options, const Progress& progress) {
  CleanPass pass;
  progress("intersect");
  const auto soup = std::make_shared<const Soup>(make_soup(mesh));
  const Borders borders = find_borders(*soup, mesh);
  if (options.check_orientation && !borders.is_oriented) refuse_orientation(*soup, mesh);
  if (!borders.loops.empty() && options.method == ExteriorMethod::static_test) {
    throw UsageError("--method static needs a closed mesh; this one has " +
                     std::to_string(borders.loops.size()) +
                     (borders.loops.size() == 1 ? " border" : " borders") + ": use --method grow");
  }
  const std::vector<FacePair> pairs = find_soup_intersections(*soup, progress);
  const Arrangement arrangement = arrange(soup, pairs, progress);
  pass.exterior = find_exterior(arrangement, options.level, options.method,
                                close_borders(*soup, borders.loops), progress);

  const auto& kept = pass.exterior.kept;
  const auto whole_end = kept.begin() + static_cast<std::ptrdiff_t>(arrangement.whole_pieces);
  pass.pairs = pairs.size();
  pass.cut_faces = soup->faces.size() - arrangement.whole_pieces;
  pass.removed_faces = static_cast<std::size_t>(std::count(kept.begin(), whole_end, 0));
  pass.unchanged = pass.cut_faces == 0 && pass.removed_faces == 0 &&
                   soup->faces.size() == mesh.faces.size() && is_stitched(mesh, borders);
  progress("stitch");
  if (!pass.unchanged) pass.assembly = assemble(mesh, arrangement, kept);
  return pass;
}

}  // namespace transformesh
