#include "remesh/operations/safe_split.h"

#include <algorithm>
#include <span>
#include <utility>

#include "clean/intersect/contacts.h"
#include "geometry/numbers/predicates.h"
#include "remesh/guards/exact_guard.h"

namespace transformesh {
namespace {

/// Compares the contacts of a mesh after its edges were split with those before.
class ContactCheck {
 public:
  ContactCheck(const EditableMesh& before, const EditableMesh& after,
               std::span<const Index> parents)
      : before_(before), after_(after), parents_(parents), guard_(after) {}

  /// True if a face at the vertex intersects others or has no area, although the face of which it
  /// is a part did not.
  bool is_worse_at(Index vertex) const {
    bool is_worse = false;
    after_.for_each_outgoing(
        vertex, [&](Index halfedge) { is_worse = is_worse || is_worse_in(halfedge / 3); });
    return is_worse;
  }

 private:
  Index root_of(Index face) const {
    while (face >= before_.face_slots()) face = parents_[face - before_.face_slots()];
    return face;
  }

  bool is_worse_in(Index face) const {
    const Triangle triangle = after_.triangle(face);
    const Index root = root_of(face);
    if (has_no_area(triangle)) return !has_no_area(before_.triangle(root));
    return !guard_.for_each_near(triangle, [&](Index other) {
      return other == face || !triangles_meet(triangle, after_.triangle(other)) ||
             have_met(root, root_of(other));
    });
  }

  bool have_met(Index first, Index second) const {
    return first != second && triangles_meet(before_.triangle(first), before_.triangle(second));
  }

  static bool has_no_area(const Triangle& triangle) {
    return collinear(triangle[0], triangle[1], triangle[2]);
  }

  const EditableMesh& before_;
  const EditableMesh& after_;
  std::span<const Index> parents_;
  ExactGuard guard_;
};

bool is_worse(const EditableMesh& before, const EditableMesh& after, std::span<const Index> parents,
              std::span<const Index> vertices) {
  if (vertices.empty()) return false;
  const ContactCheck check(before, after, parents);
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](Index vertex) { return check.is_worse_at(vertex); });
}

}  // namespace

SafeSplits split_safely(EditableMesh& mesh, const SafeSplitOptions& options,
                        const Progress& progress) {
  const EditableMesh before = mesh;
  const Index first_new = mesh.vertex_slots();
  SplitCounts counts = split_long_edges(mesh, options.limits, progress);
  SafeSplits result{options.make_guard(), counts.done};
  const std::vector<Index> in_contact = settle_midpoints(mesh, *result.guard, first_new);
  result.refused = in_contact.size();
  if (!is_worse(before, mesh, counts.parents, in_contact)) {
    result.ends = std::move(counts.ends);
    return result;
  }

  mesh = before;
  counts = split_long_edges_exactly(mesh, options.limits, progress);
  return {options.make_guard(), counts.done, counts.refused};
}

}  // namespace transformesh
