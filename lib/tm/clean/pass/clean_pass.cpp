#include "tm/clean/pass/clean_pass.h"

#include <algorithm>
#include <memory>
#include <string>

#include "tm/clean/arrange/arrange.h"
#include "tm/clean/exterior/close_borders.h"
#include "tm/clean/intersect/intersect.h"
#include "tm/clean/open/borders.h"
#include "tm/clean/open/enclosed_sheets.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

// In front of a piece of an open mesh the winding number is no integer.
void refuse_static_test(std::size_t borders) {
  throw UsageError("--method static needs a closed mesh; this one has " + std::to_string(borders) +
                   (borders == 1 ? " border" : " borders") + ": use --method grow");
}

void count_faces(const Mesh& mesh, const Arrangement& arrangement, const Borders& borders,
                 CleanPass& pass) {
  const auto& kept = pass.exterior.kept;
  const auto whole_end = kept.begin() + static_cast<std::ptrdiff_t>(arrangement.whole_pieces);
  pass.cut_faces = arrangement.welded->faces.size() - arrangement.whole_pieces;
  pass.removed_faces += static_cast<std::size_t>(std::count(kept.begin(), whole_end, 0));
  pass.unchanged = pass.cut_faces == 0 && pass.removed_faces == 0 &&
                   arrangement.welded->faces.size() == mesh.faces.size() &&
                   is_stitched(mesh, borders);
}

}  // namespace

CleanPass run_clean_pass(const Mesh& mesh, const PassOptions& options, const Progress& progress) {
  progress("intersect");
  const auto welded = std::make_shared<const WeldedMesh>(weld(mesh));
  Borders borders = options.check_orientation ? find_oriented_borders(*welded, mesh)
                                              : find_borders(*welded, mesh);
  const std::vector<FacePair> pairs = find_intersections(*welded, progress);
  CleanPass pass;
  pass.pairs = count_pairs(*welded, pairs);
  if (pass.pairs > options.most_pairs) return pass;

  Arrangement arrangement = arrange(welded, pairs, progress);
  pass.is_open = !borders.loops.empty();
  if (pass.is_open)
    pass.removed_faces = drop_enclosed_sheets(mesh, options.level, arrangement, borders, progress);
  if (options.method == ExteriorMethod::static_test && !borders.loops.empty())
    refuse_static_test(borders.loops.size());
  pass.exterior = find_exterior(arrangement, options.level, options.method,
                                close_borders(*arrangement.welded, borders.loops), progress);

  if (options.change_kept) options.change_kept(arrangement, pass.exterior.kept);
  count_faces(mesh, arrangement, borders, pass);
  progress("stitch");
  if (!pass.unchanged) pass.assembly = assemble(mesh, arrangement, pass.exterior.kept);
  return pass;
}

}  // namespace transformesh
