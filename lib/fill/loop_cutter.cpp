#include "fill/loop_cutter.h"

#include <algorithm>
#include <utility>

namespace transformesh {

LoopCutter::LoopCutter(Mesh& mesh, Scalar coordinate, std::vector<Index> opposites)
    : mesh_(mesh),
      coordinate_(coordinate),
      stars_(mesh, std::move(opposites)),
      clearance_(mesh, stars_),
      is_near_(mesh.positions.size(), 0) {}

bool LoopCutter::has_room(const std::vector<Index>& loop) const {
  return std::none_of(loop.begin(), loop.end(), [&](Index v) { return is_near_[v]; });
}

// Marks the vertices of the loop and their neighbors, so that has_room() is false for loops through
// them. Must be called before the surface is cut along the loop.
void LoopCutter::take_room(const std::vector<Index>& loop) {
  for (const Index vertex : loop) {
    is_near_[vertex] = 1;
    stars_.visit(vertex, [&](Index h) { is_near_[halfedge_target(mesh_, h)] = 1; });
  }
}

CutOutcome LoopCutter::cut(const std::vector<Index>& loop) {
  for (const Index vertex : loop) is_near_[vertex] = 1;
  const SlitSides sides = sides_of(mesh_, loop, stars_);
  const auto patch = patch_of_slit(mesh_, loop, sides, stars_);
  if (!patch) return CutOutcome::no_patch;
  const ClosedSlit slit = drawn_apart(mesh_, loop, sides, *patch, coordinate_);
  if (!clearance_.is_free(loop, sides, slit)) return CutOutcome::in_the_way;
  clearance_.take(loop, sides, slit);
  take_room(loop);
  const std::size_t faces = mesh_.faces.size();
  close_slit(mesh_, loop, sides, *patch, slit);
  mesh_.face_columns.concatenate(Columns(), faces, mesh_.faces.size() - faces);
  return CutOutcome::done;
}

}  // namespace transformesh
