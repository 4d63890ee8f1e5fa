#include "clean/stitch/coincident_sheets.h"

#include <algorithm>
#include <array>
#include <ranges>
#include <utility>

#include "clean/exterior/angular_order.h"

namespace transformesh {
namespace {

/// An edge at which exactly two bundles meet, with equally many faces each. A bundle is a set of
/// faces with the same three corners.
struct Joint {
  Index edge;
  Index first, second;  ///< indices of the two bundles, sets of faces with the same corners
};

/// Groups faces with the same three corners to bundles, and assigns the faces of each bundle to
/// different layers. A layer is one of several coincident copies of a surface.
class Layers {
 public:
  Layers(const Mesh& mesh, const Edges& edges) : mesh_(mesh), edges_(edges) {
    collect_bundles();
    collect_joints();
  }
  void add_neighbors(std::vector<Index>& across);

 private:
  std::vector<Index> faces_at_multiple_edges() const;
  void collect_bundles();
  void collect_joints();
  void grow(Index first);
  void order_layers(const Joint& joint, Index from, Index to);
  bool points_forward(Index face, Index edge) const;
  Index halfedge_of(Index face, Index edge) const;
  bool is_turned(const Joint& joint) const;

  const Mesh& mesh_;
  const Edges& edges_;
  /// For each face, its bundle (set of faces with the same three corners). no_index if no edge of
  /// the face has more than two faces.
  std::vector<Index> bundle_of_;
  /// Faces of each bundle (set of faces with the same corners). If `is_ordered_` is set for the
  /// bundle, its face `i` is in layer `i`, which is one of several copies of a surface.
  std::vector<std::vector<Index>> bundles_;
  std::vector<Joint> joints_;
  /// For each bundle (set of faces with the same corners), its entries in `joints_`, as indices.
  std::vector<std::vector<Index>> joints_at_;
  /// For each bundle (set of faces with the same corners): 1 if its faces are in layer order.
  std::vector<char> is_ordered_;
  /// For each bundle (set of faces with the same corners): 1 if its face with the smallest index
  /// must be reversed. The reversed face agrees in orientation with the face with the smallest
  /// index of the bundle that `part_of_` has for this bundle.
  std::vector<char> is_turned_;
  /// For each bundle (set of faces with the same corners), the first bundle that is connected with
  /// it by joints.
  std::vector<Index> part_of_;
  /// 1 for the first bundle of a connected set of bundles if the surface of this set is one-sided,
  /// like a Moebius strip.
  std::vector<char> has_one_side_;
};

// Returns the faces with an edge of more than two faces, ascending. If the result contains a face,
// it contains all faces with the same corners, because these have the same edges.
std::vector<Index> Layers::faces_at_multiple_edges() const {
  std::vector<Index> faces;
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (edges_.halfedges(e).size() > 2)
      for (const Index h : edges_.halfedges(e)) faces.push_back(h / 3);
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void Layers::collect_bundles() {
  std::vector<std::pair<Face, Index>> faces;  // sorted corners and face index
  for (const Index f : faces_at_multiple_edges()) {
    Face corners = mesh_.faces[f];
    std::ranges::sort(corners);
    faces.emplace_back(corners, f);
  }
  std::ranges::sort(faces);
  bundle_of_.assign(mesh_.faces.size(), no_index);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i == 0 || faces[i].first != faces[i - 1].first) bundles_.emplace_back();
    bundles_.back().push_back(faces[i].second);
    bundle_of_[faces[i].second] = static_cast<Index>(bundles_.size() - 1);
  }
}

void Layers::collect_joints() {
  joints_at_.resize(bundles_.size());
  for (Index e = 0; e < edges_.size(); ++e) {
    const auto halfedges = edges_.halfedges(e);
    if (halfedges.size() <= 2) continue;
    const Index first = bundle_of_[halfedges[0] / 3];
    const auto other =
        std::ranges::find_if(halfedges, [&](Index h) { return bundle_of_[h / 3] != first; });
    if (other == halfedges.end()) continue;
    const Index second = bundle_of_[*other / 3];
    const std::size_t layers = bundles_[first].size();
    if (bundles_[second].size() != layers || halfedges.size() != 2 * layers) continue;
    for (const Index bundle : {first, second})
      joints_at_[bundle].push_back(static_cast<Index>(joints_.size()));
    joints_.push_back({e, first, second});
  }
}

Index Layers::halfedge_of(Index face, Index edge) const {
  const auto halfedges = edges_.halfedges(edge);
  return *std::ranges::lower_bound(halfedges, 3 * face);
}

bool Layers::points_forward(Index face, Index edge) const {
  return is_forward(mesh_.faces, halfedge_of(face, edge));
}

// True if the lowest faces of the two bundles traverse the edge in the same direction. The lowest
// face is the one with the smallest index.
bool Layers::is_turned(const Joint& joint) const {
  const auto lowest = [&](Index bundle) { return *std::ranges::min_element(bundles_[bundle]); };
  return points_forward(lowest(joint.first), joint.edge) ==
         points_forward(lowest(joint.second), joint.edge);
}

void Layers::order_layers(const Joint& joint, Index from, Index to) {
  // The faces of bundle `to` that have no layer yet: first those that traverse the edge backward,
  // then those that traverse it forward. In each list the face with the lowest index is last.
  std::array<std::vector<Index>, 2> left;
  for (auto face = bundles_[to].rbegin(); face != bundles_[to].rend(); ++face)
    left[points_forward(*face, joint.edge) ? 1 : 0].push_back(*face);
  std::vector<Index> ordered(bundles_[to].size(), no_index);
  for (const bool agrees : {true, false})
    for (std::size_t layer = 0; layer < ordered.size(); ++layer) {
      if (ordered[layer] != no_index) continue;
      const bool forward = points_forward(bundles_[from][layer], joint.edge);
      std::vector<Index>& faces = left[forward == agrees ? 0 : 1];
      if (faces.empty()) continue;
      ordered[layer] = faces.back();
      faces.pop_back();
    }
  bundles_[to] = ordered;
}

void Layers::grow(Index first) {
  std::vector<Index> part{first};
  is_ordered_[first] = 1;
  part_of_[first] = first;
  for (std::size_t i = 0; i < part.size(); ++i)
    for (const Index number : joints_at_[part[i]]) {
      const Joint& joint = joints_[number];
      const Index next = joint.first == part[i] ? joint.second : joint.first;
      const char turned = is_turned_[part[i]] != (is_turned(joint) ? 1 : 0);
      if (!is_ordered_[next]) {
        is_ordered_[next] = 1;
        is_turned_[next] = turned;
        part_of_[next] = first;
        order_layers(joint, part[i], next);
        part.push_back(next);
      } else if (is_turned_[next] != turned) {
        has_one_side_[first] = 1;
      }
    }
}

void Layers::add_neighbors(std::vector<Index>& across) {
  is_ordered_.assign(bundles_.size(), 0);
  is_turned_.assign(bundles_.size(), 0);
  has_one_side_.assign(bundles_.size(), 0);
  part_of_.assign(bundles_.size(), no_index);
  for (Index bundle = 0; bundle < bundles_.size(); ++bundle)
    if (!is_ordered_[bundle] && !joints_at_[bundle].empty()) grow(bundle);
  for (const auto& [edge, first, second] : joints_) {
    if (has_one_side_[part_of_[first]]) continue;
    for (std::size_t layer = 0; layer < bundles_[first].size(); ++layer) {
      const Index h = halfedge_of(bundles_[first][layer], edge);
      const Index other = halfedge_of(bundles_[second][layer], edge);
      across[h] = other;
      across[other] = h;
    }
  }
}

}  // namespace

std::vector<Index> neighbors_in_layers(const Mesh& mesh, const Edges& edges) {
  std::vector<Index> across = neighbors_across(edges, mesh.faces.size());
  Layers(mesh, edges).add_neighbors(across);
  return across;
}

}  // namespace transformesh
