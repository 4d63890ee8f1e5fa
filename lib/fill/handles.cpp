#include "transformesh/handles.h"

#include "fill/loop_cutter.h"
#include "fill/short_loops.h"
#include "mesh/adjacency.h"
#include "mesh/surface_columns.h"
#include "support/error_prefix.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"

namespace transformesh {
namespace {

std::vector<Index> opposites_for_handles(const Mesh& mesh) {
  if (auto opposites = closed_opposites(mesh, opposite_halfedges(mesh))) return *opposites;
  throw InputError(prefixed("handles are removed only from closed oriented manifolds, but ",
                            manifold_problem(mesh, check_manifold(mesh), true)));
}

/// Makes one round of cuts along short loops (short_loops.h). The cuts of a round have no
/// neighboring vertices in common, so that no cut changes the surface around another one. Their
/// loops are homologically independent (homology.h), so that each cut removes a handle.
HandleResult remove_round(Mesh& mesh, const HandleOptions& options, const Progress& progress) {
  LoopCutter cutter(mesh, options.coordinate, opposites_for_handles(mesh));
  HandleResult result;
  IndependentWords removed;
  for (const ShortLoop& loop : short_loops(mesh, cutter.stars(), options.max_length, progress)) {
    progress("remove handles");
    if (!cutter.has_room(loop.vertices) || !removed.is_new(loop.word)) continue;
    const CutOutcome outcome = cutter.cut(loop.vertices);
    if (outcome != CutOutcome::done) {
      ++(outcome == CutOutcome::no_patch ? result.refused : result.blocked);
      continue;
    }
    removed.add(loop.word);
    ++result.removed;
  }
  return result;
}

}  // namespace

HandleResult remove_handles(Mesh& mesh, const HandleOptions& options, const Progress& progress) {
  if (!(options.max_length > 0)) throw UsageError("the loop's length must be greater than 0");
  const std::size_t vertices = mesh.positions.size(), faces = mesh.faces.size();
  HandleResult all;
  for (bool goes_on = true; goes_on;) {
    const HandleResult last = remove_round(mesh, options, progress);
    all.removed += last.removed;
    all.refused = last.refused;
    all.blocked = last.blocked;
    goes_on = last.removed > 0;
  }
  all.new_vertices = mesh.positions.size() - vertices;
  all.new_faces = mesh.faces.size() - faces;
  if (all.removed > 0) all.dropped_source_points = drop_source_points(mesh);
  return all;
}

}  // namespace transformesh
