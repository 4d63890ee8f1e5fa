#include "remesh/guards/exact_guard.h"

#include <algorithm>

#include "clean/intersect/contacts.h"
#include "geometry/numbers/predicates.h"
#include "remesh/halfedges/select_slots.h"

namespace transformesh {
namespace {

bool has_no_area(const Triangle& triangle) {
  return collinear(triangle[0], triangle[1], triangle[2]);
}

bool holds(const FloatBox& outer, const FloatBox& inner) {
  for (std::size_t i = 0; i < 3; ++i)
    if (outer.min()[i] > inner.min()[i] || outer.max()[i] < inner.max()[i]) return false;
  return true;
}

}  // namespace

ExactGuard::ExactGuard(const EditableMesh& mesh, double slack)
    : mesh_(mesh), slack_(slack), leaf_of_(mesh.face_slots(), no_index) {
  frame_ = BoxFrame(positions_of(mesh));
  std::vector<FloatBox> boxes;
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    if (!mesh.has_face(face)) continue;
    leaf_of_[face] = static_cast<Index>(nodes_.size());
    boxes.push_back(box_of(mesh.triangle(face)));
    nodes_.push_back({boxes.back(), face});
  }
  bvh_ = Bvh(boxes);
}

FloatBox ExactGuard::box_of(const Triangle& t) const {
  const Vec3 slack = Vec3::Constant(slack_);
  return frame_.box(t[0].cwiseMin(t[1]).cwiseMin(t[2]) - slack,
                    t[0].cwiseMax(t[1]).cwiseMax(t[2]) + slack);
}

void ExactGuard::divide(Index face, std::span<const Index> parts) {
  const Index node = leaf_of_[face];
  nodes_[node].face = no_index;
  nodes_[node].first_child = static_cast<Index>(nodes_.size());
  nodes_[node].children = static_cast<Index>(parts.size());
  leaf_of_.resize(mesh_.face_slots(), no_index);
  for (const Index part : parts) {
    if (leaf_of_[part] != no_index) nodes_[leaf_of_[part]].face = no_index;
    leaf_of_[part] = static_cast<Index>(nodes_.size());
    nodes_.push_back({box_of(mesh_.triangle(part)), part, node});
    widen(node, nodes_.back().box);
  }
}

/// Enlarges the boxes of a node and its ancestors until they contain another box: rounding moves
/// the parts of a divided face out of its box.
void ExactGuard::widen(Index node, const FloatBox& box) {
  while (!holds(nodes_[node].box, box)) {
    nodes_[node].box = nodes_[node].box.merged(box);
    if (nodes_[node].parent == no_index) {
      widened_.push_back(node);
      return;
    }
    node = nodes_[node].parent;
  }
}

bool ExactGuard::visit_below(Index root, const FloatBox& box,
                             const std::function<bool(Index)>& visit) const {
  std::vector<Index> waiting{root};
  while (!waiting.empty()) {
    const Node& node = nodes_[waiting.back()];
    waiting.pop_back();
    if (!node.box.intersects(box)) continue;
    if (node.face != no_index && mesh_.has_face(node.face) && !visit(node.face)) return false;
    for (Index i = 0; i < node.children; ++i) waiting.push_back(node.first_child + i);
  }
  return true;
}

bool ExactGuard::for_each_near(const Triangle& triangle,
                               const std::function<bool(Index)>& visit) const {
  const FloatBox box = box_of(triangle);
  bool goes_on = true;
  bvh_.visit_overlaps(box, [&](Index root) {
    goes_on = visit_below(root, box, visit);
    return goes_on;
  });
  return goes_on && std::all_of(widened_.begin(), widened_.end(),
                                [&](Index root) { return visit_below(root, box, visit); });
}

/// True if each remaining face that the triangle meets also met one of the replaced faces.
bool ExactGuard::keeps_apart(const Triangle& triangle, std::span<const Index> replaced) const {
  return for_each_near(triangle, [&](Index face) {
    if (std::find(replaced.begin(), replaced.end(), face) != replaced.end()) return true;
    const Triangle other = mesh_.triangle(face);
    return !triangles_meet(triangle, other) ||
           std::any_of(replaced.begin(), replaced.end(),
                       [&](Index old) { return triangles_meet(mesh_.triangle(old), other); });
  });
}

bool ExactGuard::allows(std::span<const Triangle> made, std::span<const Index> replaced) const {
  const bool had_area = std::none_of(replaced.begin(), replaced.end(),
                                     [&](Index face) { return has_no_area(mesh_.triangle(face)); });
  if (had_area && std::any_of(made.begin(), made.end(), has_no_area)) return false;
  bool met = false;
  for (std::size_t i = 0; i < replaced.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      met = met || triangles_meet(mesh_.triangle(replaced[i]), mesh_.triangle(replaced[j]));
  for (std::size_t i = 0; i < made.size() && !met; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (triangles_meet(made[i], made[j])) return false;
  return std::all_of(made.begin(), made.end(),
                     [&](const Triangle& triangle) { return keeps_apart(triangle, replaced); });
}

}  // namespace transformesh
