#include "remesh/guards/face_tree.h"

#include <cmath>

#include "geometry/search/closest_point.h"
#include "geometry/search/hilbert.h"
#include "remesh/halfedges/select_slots.h"
#include "remesh/halfedges/valences.h"

namespace transformesh {
namespace {

bool is_empty(const FloatBox& box) { return box.min().x() > box.max().x(); }

}  // namespace

// A tree with n leaves has n - 1 inner nodes, which come first.
FaceTree::FaceTree(const EditableMesh& mesh)
    : mesh_(mesh),
      frame_(positions_of(mesh)),
      valences_(valences_of(mesh)),
      leaf_of_(mesh.face_slots(), no_index) {
  std::vector<FloatBox> boxes;
  std::vector<Index> faces;
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    if (!mesh.has_face(face)) continue;
    faces.push_back(face);
    boxes.push_back(box_of(mesh.triangle(face)));
  }
  if (faces.empty()) return;
  nodes_.resize(2 * faces.size() - 1);
  for (const Index place : hilbert_order(boxes)) {
    const std::size_t leaf = faces.size() - 1 + face_of_.size();
    leaf_of_[faces[place]] = static_cast<Index>(leaf);
    face_of_.push_back(faces[place]);
    nodes_[leaf] = leaf_node(faces[place]);
  }
  for (std::size_t node = faces.size() - 1; node-- > 0;)
    nodes_[node] = merged(nodes_[2 * node + 1], nodes_[2 * node + 2]);
}

FloatBox FaceTree::box_of(const Triangle& triangle) const {
  const auto& [a, b, c] = triangle;
  return frame_.box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
}

FaceTree::Node FaceTree::leaf_node(Index face) const {
  if (!mesh_.has_face(face)) return {};
  Node leaf{box_of(mesh_.triangle(face))};
  Index most = most_uncrowded;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Index vertex = mesh_.source(h);
    if (valences_[vertex] <= most) continue;
    most = valences_[vertex];
    leaf.hub = {vertex, arc_box(mesh_.position(vertex), mesh_.position(mesh_.target(h)),
                                mesh_.position(mesh_.apex(h)))};
  }
  return leaf;
}

FaceTree::Node FaceTree::merged(const Node& first, const Node& second) {
  if (is_empty(first.box)) return second;
  if (is_empty(second.box)) return first;
  Node node{first.box.merged(second.box)};
  if (first.hub.link == second.hub.link)
    node.hub = {first.hub.link, first.hub.box.merged(second.hub.box)};
  return node;
}

/// True if all faces below the node are farther from the point than the distance, because of the
/// directions in which they leave their common vertex.
bool FaceTree::is_beyond(const Vec3& point, double squared_distance, const Node& node) const {
  constexpr double rounding = 1e-9;  // exceeds the relative rounding error of squared distances
  if (node.hub.link == no_index) return false;
  const Vec3 away = point - mesh_.position(node.hub.link);
  const double squared_length = away.squaredNorm();
  // The chord between directions at an angle of a has length 2 sin(a / 2).
  const double squared_chord =
      node.hub.box.cast<double>().squaredExteriorDistance(Vec3(away / std::sqrt(squared_length)));
  const double squared_sine = squared_chord < 2 ? squared_chord * (1 - squared_chord / 4) : 1;
  return squared_length * squared_sine > (1 + rounding) * squared_distance;
}

Index FaceTree::closest_face_within(const Vec3& point, double distance, Index hint) const {
  Index best = no_index;
  double least = distance * distance;
  FloatBox ball;
  const auto set_ball = [&](double radius) {
    ball = frame_.box(point.array() - radius, point.array() + radius);
  };
  const auto offer = [&](Index face) {
    const auto [a, b, c] = mesh_.triangle(face);
    const Vec3 away = closest_point_of_triangle(point, a, b, c).point - point;
    const double squared = MedianTree::squared_length(away.x(), away.y(), away.z());
    if (squared > least || (squared == least && face > best)) return true;
    best = face;
    if (squared < least) set_ball(std::sqrt(squared));
    least = squared;
    return true;
  };
  set_ball(distance);
  if (hint != no_index) offer(hint);
  const auto accept = [&](const Node& node) {
    return node.box.intersects(ball) && !is_beyond(point, least, node);
  };
  visit_where(accept, offer);
  return best;
}

void FaceTree::update(Index face) {
  const auto are_equal = [](const FloatBox& a, const FloatBox& b) {
    return a.min() == b.min() && a.max() == b.max();
  };
  std::size_t place = leaf_of_[face];
  Node node = leaf_node(face);
  while (!are_equal(node.box, nodes_[place].box) || node.hub.link != nodes_[place].hub.link ||
         !are_equal(node.hub.box, nodes_[place].hub.box)) {
    nodes_[place] = node;
    if (place == 0) return;
    place = (place - 1) / 2;
    node = merged(nodes_[2 * place + 1], nodes_[2 * place + 2]);
  }
}

}  // namespace transformesh
