// Stitching: for any triangles, the result is an oriented manifold. It has borders only at edges
// that are not traversed equally often in both directions.
#include "transformesh/stitch.h"

#include "fuzz/tiny_mesh.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"

using namespace transformesh;
using namespace transformesh::fuzz;

void transformesh::fuzz::run_target(std::string_view bytes) {
  Choices choices(bytes);
  StitchOptions options;
  options.tolerance = choices.flag() ? choices.byte() / 16.0 : 0;
  options.orient = choices.flag();
  options.one_side = choices.flag();
  options.drop_copies = choices.flag();
  Mesh mesh = tiny_mesh(choices);
  const bool is_closed = is_closed_by_position(mesh);
  StitchResult result;
  try {
    result = stitch(mesh, options);
  } catch (const InputError&) {
    demand(options.orient || options.one_side, "refused, although nothing is to be oriented");
    return;
  }
  const ManifoldReport report = check_manifold(mesh);
  // A sheet with its reverse is closed; one side of it is left.
  const bool stays_closed =
      is_closed && options.tolerance == 0 && !options.one_side && !options.drop_copies;
  const std::string problem = manifold_problem(mesh, report, stays_closed).sentence;
  demand(problem.empty(), problem);
  // These have several borders each.
  if (result.misoriented_edges + result.split_edges > 0) return;
  demand(report.border_halfedges.size() == result.border_edges, "another number of border edges");
}
