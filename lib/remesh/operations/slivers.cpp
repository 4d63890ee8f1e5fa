#include "remesh/operations/slivers.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/predicates.h"
#include "mesh/coordinate_spacing.h"
#include "remesh/guards/exact_guard.h"
#include "remesh/halfedges/select_slots.h"
#include "remesh/operations/degenerate.h"

namespace transformesh {
namespace {

/// Largest height of a sliver, as a share of the shortest edge; the table in the header shows its
/// effect.
constexpr double thin_share = 1e-5;
/// Largest height of a sliver in spacings of coordinates. Lower heights are mostly rounding error.
constexpr double thin_spacings = 4;
/// Each round moves the surface by at most two heights of slivers. All rounds therefore remain
/// within the slack of the guard.
constexpr int most_sliver_rounds = 16;
constexpr double slack_heights = 4 * most_sliver_rounds;

double longest_edge(const Triangle& t) {
  return std::sqrt(std::max(
      {(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()}));
}

/// The shortest and the longest edge of a face, as halfedges.
struct Sides {
  Index shortest;
  Index longest;

  Sides(const EditableMesh& mesh, Index face) : shortest(3 * face), longest(3 * face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (mesh.squared_length(h) < mesh.squared_length(shortest)) shortest = h;
      if (mesh.squared_length(h) > mesh.squared_length(longest)) longest = h;
    }
  }
};

class SliverRemoval {
 public:
  SliverRemoval(EditableMesh& mesh, const VertexRoles& roles, const SliverTest& is_sliver)
      : mesh_(mesh),
        roles_(roles),
        is_sliver_(is_sliver),
        guard_(mesh, slack_heights * is_sliver.largest_thickness()),
        merged_in_(mesh.vertex_slots(), 0) {}

  /// Returns the number of removed slivers.
  std::size_t run_round() {
    ++round_;
    const std::vector<Index> slivers = indices_where(
        mesh_.face_slots(), [&](Index face) { return mesh_.has_face(face) && is_sliver_(face); });
    return static_cast<std::size_t>(
        std::count_if(slivers.begin(), slivers.end(), [&](Index face) { return remove(face); }));
  }

 private:
  bool remove(Index face) {
    if (!mesh_.has_face(face) || !is_sliver_(face)) return false;
    const Sides sides(mesh_, face);
    const double thickness = is_sliver_.thickness(mesh_.triangle(face));
    const bool is_needle = mesh_.squared_length(sides.shortest) <= thickness * thickness;
    if (is_needle && (collapse(sides.shortest) || collapse_back(sides.shortest))) return true;
    return flip(sides.longest);
  }

  bool collapse_back(Index halfedge) {
    return !mesh_.is_border(halfedge) && collapse(mesh_.opposite(halfedge));
  }

  /// Merges the source of the halfedge into its target, which keeps its position.
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

  /// Flips the longest edge of a sliver. Both new faces are parts of the face across that edge and
  /// take its attributes.
  bool flip(Index halfedge) {
    if (mesh_.is_border(halfedge) || !mesh_.can_flip(halfedge)) return false;
    const Index sliver = halfedge / 3;
    const Index across = mesh_.opposite(halfedge) / 3;
    const Vec3& left = mesh_.position(mesh_.apex(halfedge));
    const Vec3& right = mesh_.position(mesh_.apex(mesh_.opposite(halfedge)));
    start();
    replaced_ = {sliver, across};
    made_.push_back({left, mesh_.position(mesh_.source(halfedge)), right});
    made_.push_back({right, mesh_.position(mesh_.target(halfedge)), left});
    const bool is_shorter = (right - left).squaredNorm() < mesh_.squared_length(halfedge);
    if (!is_progress(across, is_shorter) || !guard_.allows(made_, replaced_)) return false;
    mesh_.flip(halfedge);
    mesh_.copy_face_row(across, sliver);
    guard_.divide(across, replaced_);
    return true;
  }

  /// True if a flip leaves fewer slivers, or as many slivers and a shorter edge. Therefore flips
  /// end.
  bool is_progress(Index across, bool is_shorter) const {
    const auto is_made_thin = [&](const Triangle& t) { return is_sliver_.is_sliver(t); };
    const auto after = std::count_if(made_.begin(), made_.end(), is_made_thin);
    const int before = is_sliver_(across) ? 2 : 1;
    return after < before || (after == before && is_shorter);
  }

  void start() {
    made_.clear();
    replaced_.clear();
  }

  EditableMesh& mesh_;
  const VertexRoles& roles_;
  const SliverTest& is_sliver_;
  ExactGuard guard_;
  int round_ = 0;
  std::vector<int>
      merged_in_;  ///< for each vertex the last round in which another vertex was merged into it
  std::vector<Triangle> made_;
  std::vector<Index> replaced_;
};

}  // namespace

SliverTest::SliverTest(const EditableMesh& mesh, double shortest)
    : mesh_(mesh), least_(thin_share * shortest) {}

double SliverTest::thickness(const Triangle& t) const {
  const Vec3 largest = t[0].cwiseAbs().cwiseMax(t[1].cwiseAbs()).cwiseMax(t[2].cwiseAbs());
  return std::max(least_, thin_spacings * spacing_around(largest, mesh_.coordinate()));
}

bool SliverTest::is_sliver(const Triangle& t) const {
  const double longest = longest_edge(t);
  const double height = std::min(thickness(t), least_height * longest);
  return normal_of(t[0], t[1], t[2]).norm() <= height * longest;
}

double SliverTest::largest_thickness() const {
  double largest = 0;
  for (Index v = 0; v < mesh_.vertex_slots(); ++v)
    if (mesh_.has_vertex(v)) largest = std::max(largest, mesh_.position(v).cwiseAbs().maxCoeff());
  return thickness({Vec3::Constant(largest), Vec3::Zero(), Vec3::Zero()});
}

Slivers count_slivers(const EditableMesh& mesh, const SliverTest& is_sliver) {
  Slivers result;
  for (const Index face : degenerate_faces(mesh)) {
    ++result.degenerate;
    if (!is_sliver(face)) continue;
    const auto [a, b, c] = mesh.triangle(face);
    if (result.kept++ == 0) result.place = a;
    if (collinear(a, b, c)) ++result.without_area;
  }
  return result;
}

void remove_slivers(EditableMesh& mesh, const VertexRoles& roles, const SliverTest& is_sliver) {
  SliverRemoval removal(mesh, roles, is_sliver);
  for (int round = 0; round < most_sliver_rounds && removal.run_round() > 0; ++round) {
  }
}

}  // namespace transformesh
