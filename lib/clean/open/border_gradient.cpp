#include "clean/open/border_gradient.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numbers>

#include "geometry/counted_edges.h"

namespace transformesh {
namespace {

/// A node counts as a whole if its distance from the box is at least this many times its diagonal.
/// Larger values give lower bounds and need more time. With 2, a bound is at most 9/4 times as
/// large as with all edges one by one.
constexpr double far = 2;

}  // namespace

BorderGradient::BorderGradient(const Mesh& mesh) {
  CountedEdges border;
  for (const Face& face : mesh.faces) append_edges(face, border);
  std::sort(border.begin(), border.end());
  add_up(border);
  std::vector<Node> edges;
  for (const CountedEdge& edge : border) {
    const Vec3 &low = mesh.positions[edge.low], &high = mesh.positions[edge.high];
    Node node{Box(low), std::abs(edge.count) * (high - low).stableNorm(), no_index};
    node.box.extend(high);
    edges.push_back(node);
  }
  if (!edges.empty()) build(edges, 0, edges.size());
}

// Builds the nodes of a range of edges, halved along the longest side of the box of their centers.
Index BorderGradient::build(std::vector<Node>& edges, std::size_t first, std::size_t last) {
  const auto number = static_cast<Index>(nodes_.size());
  nodes_.push_back(edges[first]);
  if (last - first == 1) return number;
  Box centers;
  for (std::size_t e = first; e < last; ++e) centers.extend(edges[e].box.center());
  Eigen::Index axis = 0;
  centers.sizes().maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t e) { return edges.begin() + static_cast<std::ptrdiff_t>(e); };
  std::nth_element(at(first), at(middle), at(last), [axis](const Node& a, const Node& b) {
    return a.box.center()[axis] < b.box.center()[axis];
  });
  const Index left = build(edges, first, middle), right = build(edges, middle, last);
  nodes_[number] = {nodes_[left].box.merged(nodes_[right].box),
                    nodes_[left].length + nodes_[right].length, right};
  return number;
}

double BorderGradient::in(const Box& box) const {
  return nodes_.empty() ? 0 : from(0, box) / (4 * std::numbers::pi);
}

double BorderGradient::from(Index node, const Box& box) const {
  const Node& n = nodes_[node];
  const double distance = box.exteriorDistance(n.box);
  if (n.second_child == no_index || distance >= far * n.box.diagonal().stableNorm())
    return distance > 0 ? n.length / distance / distance : std::numeric_limits<double>::infinity();
  return from(node + 1, box) + from(n.second_child, box);
}

}  // namespace transformesh
