#include "geometry/winding_hierarchy.h"

#include <algorithm>
#include <numeric>

#include "geometry/counted_edges.h"
#include "geometry/solid_angle_sum.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Largest number of faces in a leaf of the tree. If a point is in the box of a leaf, its faces are
/// summed one by one. Affects time only.
constexpr std::size_t faces_per_leaf = 16;

/// Margin of boxes, as a fraction of the largest coordinate. Points that rounding has moved off a
/// face are then still in the boxes of this face. Far above rounding errors, and far below usual
/// edge lengths.
constexpr double box_margin = 1e-9;

}  // namespace

class WindingHierarchy::Builder {
 public:
  explicit Builder(WindingHierarchy& tree)
      : tree_(tree), mesh_(*tree.mesh_), local_(mesh_.positions.size(), no_index) {
    centers_.reserve(mesh_.faces.size());
    for (const auto& [a, b, c] : mesh_.faces)
      centers_.push_back(mesh_.positions[a] / 3 + mesh_.positions[b] / 3 + mesh_.positions[c] / 3);
    tree_.order_.resize(mesh_.faces.size());
    std::iota(tree_.order_.begin(), tree_.order_.end(), Index{0});
  }

  /// Builds the tree of the faces in a range of `order_`. Returns the boundary edges of these
  /// faces.
  CountedEdges build(Range faces) {
    const std::size_t number = tree_.nodes_.size();
    tree_.nodes_.emplace_back();
    Node node;
    node.faces = faces;
    const bool is_leaf = faces.last - faces.first <= faces_per_leaf;
    CountedEdges boundary = is_leaf ? boundary_of_faces(node) : boundary_of_halves(node);
    std::size_t edges = 0;
    for (const CountedEdge& edge : boundary)
      edges += static_cast<std::size_t>(std::abs(edge.count));
    node.has_fan = edges < faces.last - faces.first;
    if (node.has_fan) add_fan(boundary, node);
    tree_.nodes_[number] = node;
    return boundary;
  }

 private:
  CountedEdges boundary_of_faces(Node& node) const {
    CountedEdges boundary;
    for (Index i = node.faces.first; i < node.faces.last; ++i) {
      const Face& face = mesh_.faces[tree_.order_[i]];
      append_edges(face, boundary);
      for (const Index v : face) node.box.extend(mesh_.positions[v]);
    }
    std::sort(boundary.begin(), boundary.end());
    add_up(boundary);
    const Vec3 margin = Vec3::Constant(box_margin * tree_.largest_coordinate_);
    node.box = Box(node.box.min() - margin, node.box.max() + margin);
    return boundary;
  }

  CountedEdges boundary_of_halves(Node& node) {
    const Index middle = split(node.faces);
    node.left = static_cast<Index>(tree_.nodes_.size());
    const CountedEdges of_left = build({node.faces.first, middle});
    node.right = static_cast<Index>(tree_.nodes_.size());
    const CountedEdges of_right = build({middle, node.faces.last});
    node.box = tree_.nodes_[node.left].box.merged(tree_.nodes_[node.right].box);
    CountedEdges boundary;
    boundary.reserve(of_left.size() + of_right.size());
    std::merge(of_left.begin(), of_left.end(), of_right.begin(), of_right.end(),
               std::back_inserter(boundary));
    add_up(boundary);
    return boundary;
  }

  // Divides the faces into two halves, at the median of their centers along the longest side of the
  // box of centers. Returns the start of the second half.
  Index split(Range faces) {
    const auto at = [&](Index place) { return tree_.order_.begin() + place; };
    Box box;
    std::for_each(at(faces.first), at(faces.last), [&](Index f) { box.extend(centers_[f]); });
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const Index middle = faces.first + (faces.last - faces.first) / 2;
    std::nth_element(at(faces.first), at(middle), at(faces.last), [&](Index a, Index b) {
      return std::pair(centers_[a][axis], a) < std::pair(centers_[b][axis], b);
    });
    return middle;
  }

  void add_fan(const CountedEdges& boundary, Node& node) {
    node.vertices.first = static_cast<Index>(tree_.vertices_.size());
    node.triangles.first = static_cast<Index>(tree_.triangles_.size());
    for (const CountedEdge& edge : boundary) add_to_fan(boundary.front().low, edge, node);
    node.vertices.last = static_cast<Index>(tree_.vertices_.size());
    node.triangles.last = static_cast<Index>(tree_.triangles_.size());
    for (const Index vertex : used_) local_[vertex] = no_index;
    used_.clear();
  }

  void add_to_fan(Index apex, const CountedEdge& edge, const Node& node) {
    if (edge.low == apex || edge.high == apex) return;
    for (int i = 0; i < std::abs(edge.count); ++i)
      add_triangle(
          edge.count > 0 ? Face{apex, edge.low, edge.high} : Face{apex, edge.high, edge.low}, node);
  }

  void add_triangle(const Face& triangle, const Node& node) {
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      Index& local = local_[triangle[k]];
      if (local == no_index) {
        local = static_cast<Index>(tree_.vertices_.size()) - node.vertices.first;
        tree_.vertices_.push_back(mesh_.positions[triangle[k]]);
        used_.push_back(triangle[k]);
      }
      corners[k] = local;
    }
    tree_.triangles_.push_back(corners);
  }

  WindingHierarchy& tree_;
  const Mesh& mesh_;
  std::vector<Vec3> centers_;
  /// For each vertex its index in the fan of the current node, or no_index.
  std::vector<Index> local_;
  std::vector<Index> used_;  ///< vertices in the fan of the current node, for resetting `local_`
};

struct WindingHierarchy::Query {
  const Vec3& point;
  std::span<const Index> left_out;
  SolidAngleSum sum;
  std::vector<Vec3> directions{};
};

WindingHierarchy::WindingHierarchy(const Mesh& mesh) : mesh_(&mesh) {
  if (mesh.faces.empty()) return;
  const Box box = bounding_box(mesh);
  largest_coordinate_ = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  Builder(*this).build({0, static_cast<Index>(mesh.faces.size())});
}

double WindingHierarchy::operator()(const Vec3& point, std::span<const Index> left_out) const {
  if (nodes_.empty()) return 0;
  Query query{point, left_out, SolidAngleSum(point, largest_coordinate_)};
  add(nodes_.front(), query);
  return query.sum.result().number;
}

void WindingHierarchy::add(const Node& node, Query& query) const {
  if (node.has_fan && !node.box.contains(query.point)) return add_fan(node, query);
  if (node.left == no_index) return add_faces(node, query);
  add(nodes_[node.left], query);
  add(nodes_[node.right], query);
}

void WindingHierarchy::add_fan(const Node& node, Query& query) const {
  query.directions.resize(node.vertices.last - node.vertices.first);
  for (Index i = node.vertices.first; i < node.vertices.last; ++i)
    query.directions[i - node.vertices.first] = query.sum.direction(vertices_[i]);
  for (Index i = node.triangles.first; i < node.triangles.last; ++i) {
    const auto& [a, b, c] = triangles_[i];
    query.sum.add(query.directions[a], query.directions[b], query.directions[c]);
  }
}

void WindingHierarchy::add_faces(const Node& node, Query& query) const {
  for (Index i = node.faces.first; i < node.faces.last; ++i) {
    if (std::ranges::find(query.left_out, order_[i]) != query.left_out.end()) continue;
    const auto& [a, b, c] = mesh_->faces[order_[i]];
    query.sum.add(query.sum.direction(mesh_->positions[a]),
                  query.sum.direction(mesh_->positions[b]),
                  query.sum.direction(mesh_->positions[c]));
  }
}

}  // namespace transformesh
