#include "transformesh/handles.h"

#include <algorithm>

#include "fill/short_loops.h"
#include "fill/slit_clearance.h"
#include "mesh/adjacency.h"
#include "mesh/surface_columns.h"
#include "support/error_prefix.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"

namespace transformesh {
namespace {

std::vector<Index> checked_opposites(const Mesh& mesh) {
  if (auto opposites = closed_opposites(mesh, opposite_halfedges(mesh))) return *opposites;
  throw InputError(prefixed("handles are removed from closed oriented manifolds only, and ",
                            manifold_problem(mesh, check_manifold(mesh), true)));
}

/// One round: slits loops that are far enough apart that each loop finds the surface unchanged.
/// Their words must be independent, so that each slit removes a handle.
class Round {
 public:
  Round(Mesh& mesh, const HandleOptions& options)
      : mesh_(mesh),
        options_(options),
        stars_(mesh, checked_opposites(mesh)),
        room_(mesh, stars_),
        is_near_(mesh.positions.size(), 0) {}

  /// Returns the numbers of handles removed and refused in this round.
  HandleResult run(const Progress& progress);

 private:
  bool has_room(const ShortLoop& loop) const;
  void take_room(const ShortLoop& loop);
  enum class Outcome { removed, no_patch, in_the_way };
  Outcome remove(const ShortLoop& loop);

  Mesh& mesh_;
  const HandleOptions& options_;
  HalfedgeStars stars_;
  SlitClearance room_;
  std::vector<char> is_near_;  ///< per vertex: on a slit or refused loop, or next to a slit one
};

bool Round::has_room(const ShortLoop& loop) const {
  return std::none_of(loop.vertices.begin(), loop.vertices.end(),
                      [&](Index v) { return is_near_[v]; });
}

// Call before the loop is slit.
void Round::take_room(const ShortLoop& loop) {
  for (const Index vertex : loop.vertices) {
    is_near_[vertex] = 1;
    stars_.visit(vertex, [&](Index h) { is_near_[halfedge_target(mesh_, h)] = 1; });
  }
}

// The mesh changes only if the handle is removed.
Round::Outcome Round::remove(const ShortLoop& loop) {
  const SlitSides sides = sides_of(mesh_, loop.vertices, stars_);
  const auto patch = patch_of_slit(mesh_, loop.vertices, sides, stars_);
  if (!patch) return Outcome::no_patch;
  const ClosedSlit slit = drawn_apart(mesh_, loop.vertices, sides, *patch, options_.coordinate);
  if (!room_.is_free(loop.vertices, sides, slit)) return Outcome::in_the_way;
  room_.take(loop.vertices, sides, slit);
  take_room(loop);
  const std::size_t faces = mesh_.faces.size();
  close_slit(mesh_, loop.vertices, sides, *patch, slit);
  mesh_.face_columns.concatenate(Columns(), faces, mesh_.faces.size() - faces);
  return Outcome::removed;
}

HandleResult Round::run(const Progress& progress) {
  HandleResult result;
  IndependentWords removed;
  for (const ShortLoop& loop : short_loops(mesh_, stars_, options_.max_length, progress)) {
    progress("remove handles");
    if (!has_room(loop) || !removed.is_new(loop.word)) continue;
    const Outcome outcome = remove(loop);
    if (outcome != Outcome::removed) {
      for (const Index v : loop.vertices) is_near_[v] = 1;
      ++(outcome == Outcome::no_patch ? result.refused : result.blocked);
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
    const HandleResult last = Round(mesh, options).run(progress);
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
