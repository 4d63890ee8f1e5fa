#include "tm/remesh/operations/slivers.h"

#include <algorithm>
#include <cmath>

#include "tm/mesh/digits.h"
#include "tm/remesh/guards/exact_guard.h"
#include "tm/remesh/halfedges/where.h"

namespace transformesh {
namespace {

/// Each round moves the surface by at most two heights, so all remain within the slack of the
/// guard.
constexpr int most_rounds = 16;
static_assert(2 * most_rounds * sliver_spacings < ExactGuard::slack_spacings);

/// The measures of a face that decide how it is removed.
struct Shape {
  Index shortest;  ///< halfedge
  Index longest;   ///< halfedge
  double shortest_length;
  double height;  ///< above the longest edge

  Shape(const EditableMesh& mesh, Index face) : shortest(3 * face), longest(3 * face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (mesh.squared_length(h) < mesh.squared_length(shortest)) shortest = h;
      if (mesh.squared_length(h) > mesh.squared_length(longest)) longest = h;
    }
    shortest_length = std::sqrt(mesh.squared_length(shortest));
    const double length = std::sqrt(mesh.squared_length(longest));
    height = length > 0 ? mesh.face_normal(face).norm() / length : 0;
  }
};

double height_of(const Triangle& t) {
  const double longest = std::sqrt(std::max(
      {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()}));
  return longest > 0 ? normal_of(t[0], t[1], t[2]).norm() / longest : 0;
}

double thickness_of_slivers(const EditableMesh& mesh, Index face) {
  const auto [a, b, c] = mesh.triangle(face);
  const Vec3 largest = a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs());
  return sliver_spacings * spacing_around(largest, mesh.coordinate());
}

class SliverRemoval {
 public:
  SliverRemoval(EditableMesh& mesh, const VertexRoles& roles)
      : mesh_(mesh), roles_(roles), guard_(mesh), merged_in_(mesh.vertex_slots(), 0) {}

  /// Returns how many steps were done.
  std::size_t run_round() {
    ++round_;
    const std::vector<Index> slivers = indices_where(mesh_.face_slots(), [&](Index face) {
      return mesh_.has_face(face) && is_sliver(mesh_, face);
    });
    return static_cast<std::size_t>(
        std::count_if(slivers.begin(), slivers.end(), [&](Index face) { return remove(face); }));
  }

 private:
  bool remove(Index face) {
    if (!mesh_.has_face(face) || !is_sliver(mesh_, face)) return false;
    const Shape shape(mesh_, face);
    const bool is_needle = shape.shortest_length <= thickness_of_slivers(mesh_, face);
    if (is_needle && (collapse(shape.shortest) || collapse_back(shape.shortest))) return true;
    return flip(shape.longest, shape.height);
  }

  bool collapse_back(Index halfedge) {
    return !mesh_.is_border(halfedge) && collapse(mesh_.opposite(halfedge));
  }

  /// Merges the source into the target, which keeps its place.
  bool collapse(Index halfedge) {
    const Index from = mesh_.source(halfedge);
    const Index to = mesh_.target(halfedge);
    if (merged_in_[from] == round_ || merged_in_[to] == round_) return false;
    if (roles_.keeps_border() && mesh_.is_border_vertex(from)) return false;
    if (!mesh_.can_collapse(halfedge)) return false;
    start();
    mesh_.for_each_outgoing(from, [&](Index h) {
      replaced_.push_back(h / 3);
      if (mesh_.target(h) == to || mesh_.apex(h) == to) return;
      made_.push_back(
          {mesh_.position(to), mesh_.position(mesh_.target(h)), mesh_.position(mesh_.apex(h))});
    });
    if (!guard_.allows(made_, replaced_)) return false;
    mesh_.collapse(halfedge, mesh_.position(to), 0);
    merged_in_[to] = round_;
    return true;
  }

  /// Flips the longest edge of a sliver. Both new faces take the place of the face across that
  /// edge.
  bool flip(Index halfedge, double height) {
    if (mesh_.is_border(halfedge) || !mesh_.can_flip(halfedge)) return false;
    const Index sliver = halfedge / 3;
    const Index across = mesh_.opposite(halfedge) / 3;
    const Vec3& left = mesh_.position(mesh_.apex(halfedge));
    const Vec3& right = mesh_.position(mesh_.apex(mesh_.opposite(halfedge)));
    start();
    replaced_ = {sliver, across};
    made_.push_back({left, mesh_.position(mesh_.source(halfedge)), right});
    made_.push_back({right, mesh_.position(mesh_.target(halfedge)), left});
    if (!(std::min(height_of(made_[0]), height_of(made_[1])) > height)) return false;
    if (!guard_.allows(made_, replaced_)) return false;
    mesh_.flip(halfedge);
    mesh_.copy_face_row(across, sliver);
    guard_.divide(across, replaced_);
    return true;
  }

  void start() {
    made_.clear();
    replaced_.clear();
  }

  EditableMesh& mesh_;
  const VertexRoles& roles_;
  ExactGuard guard_;
  int round_ = 0;
  std::vector<int>
      merged_in_;  ///< per vertex, the last round in which another one was merged into it
  std::vector<Triangle> made_;
  std::vector<Index> replaced_;
};

}  // namespace

bool is_sliver(const EditableMesh& mesh, Index face) {
  return Shape(mesh, face).height <= thickness_of_slivers(mesh, face);
}

std::size_t remove_slivers(EditableMesh& mesh, const VertexRoles& roles) {
  SliverRemoval removal(mesh, roles);
  std::size_t steps = 0;
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t done = removal.run_round();
    if (done == 0) break;
    steps += done;
  }
  return steps;
}

}  // namespace transformesh
