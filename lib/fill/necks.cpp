#include "fill/necks.h"

#include "fill/loop_cutter.h"
#include "fill/neck_loops.h"
#include "mesh/adjacency.h"
#include "support/error_prefix.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"

namespace transformesh {
namespace {

std::vector<Index> opposites_for_necks(const Mesh& mesh) {
  if (auto opposites = closed_opposites(mesh, opposite_halfedges(mesh))) return *opposites;
  throw InputError(prefixed("necks are cut only in closed oriented manifolds, but ",
                            manifold_problem(mesh, check_manifold(mesh), true)));
}

NeckResult cut_round(Mesh& mesh, double max_length, Scalar coordinate, const Progress& progress) {
  LoopCutter cutter(mesh, coordinate, opposites_for_necks(mesh));
  NeckTest test(mesh, cutter.stars());
  NeckResult result;
  for (const NeckLoop& loop : narrow_loops(mesh, cutter.stars(), max_length, progress)) {
    progress("cut necks");
    if (!cutter.has_room(loop.vertices) || !test.is_neck(loop)) continue;
    test.note_cut(loop);
    const bool is_done = cutter.cut(loop.vertices) == CutOutcome::done;
    ++(is_done ? result.cut : result.refused);
  }
  return result;
}

}  // namespace

NeckResult cut_necks(Mesh& mesh, double max_length, Scalar coordinate, const Progress& progress) {
  NeckResult all;
  for (bool goes_on = true; goes_on;) {
    const NeckResult last = cut_round(mesh, max_length, coordinate, progress);
    all.cut += last.cut;
    all.refused = last.refused;
    goes_on = last.cut > 0;
  }
  return all;
}

}  // namespace transformesh
