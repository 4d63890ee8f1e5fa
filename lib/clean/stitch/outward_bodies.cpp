#include "clean/stitch/outward_bodies.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/inward_components.h"
#include "geometry/ray_cast_winding.h"
#include "geometry/search/bvh.h"
#include "geometry/winding_hierarchy.h"
#include "mesh/local_measures.h"
#include "mesh/surface_columns.h"
#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Approximate number of vertices of a component that are tested for being inside another
/// component; the majority decides. One vertex is not enough: it may be on the surface of the other
/// component, where it does not count, and components may intersect. A choice: more vertices take
/// more time and are more robust.
constexpr std::size_t voters = 9;

class Bodies {
 public:
  explicit Bodies(const Mesh& mesh);
  /// Returns for each component whether it belongs to a body that is inside out: 1 if so, otherwise
  /// 0.
  std::vector<char> inward() const;
  /// Returns 1 for each closed component with the wrong orientation: outwards although an odd
  /// number of closed components contains it, or inwards although the number is even.
  std::vector<char> against_nesting() const;
  bool any_negative() const;
  /// True if the winding number in front of or behind a closed component is neither 0 nor 1. Only
  /// components inside others count.
  bool any_in_body() const;
  Index of_face(std::size_t face) const { return parts_.of_face[face]; }

 private:
  template <class Visit>
  void for_each_within(Index outer, const Visit& visit) const;
  std::vector<std::vector<Index>> containers() const;
  double volume(Index part) const { return parts_.components[part].volume; }
  bool is_closed(Index part) const { return parts_.components[part].boundary_loops == 0; }
  void erase_enclosed(std::vector<Index>& inners) const;
  bool most_vote(Index inner, const std::function<std::optional<bool>(const Vec3&)>& vote) const;
  Mesh mesh_of(Index part) const;

  const Mesh& mesh_;
  Components parts_;
  std::vector<char> is_negative_;  ///< 1 for closed components with a negative volume
  std::vector<Box> boxes_;
  BoxFrame frame_;
  Bvh tree_;  ///< search tree of the bounding boxes of the components
  std::vector<std::vector<Index>> faces_;
};

Bodies::Bodies(const Mesh& mesh)
    : mesh_(mesh),
      parts_(connected_components(mesh)),
      is_negative_(inward_components(mesh, parts_)),
      frame_(mesh.positions) {
  boxes_.resize(parts_.components.size());
  faces_.resize(parts_.components.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    faces_[parts_.of_face[f]].push_back(f);
    for (const Index v : mesh.faces[f]) boxes_[parts_.of_face[f]].extend(mesh.positions[v]);
  }
  std::vector<FloatBox> boxes;
  boxes.reserve(boxes_.size());
  for (const Box& box : boxes_) boxes.push_back(frame_.box(box.min(), box.max()));
  tree_ = Bvh(boxes);
}

bool Bodies::any_negative() const { return std::ranges::count(is_negative_, 1) > 0; }

Mesh Bodies::mesh_of(Index part) const {
  Mesh result;
  std::unordered_map<Index, Index> numbers;
  for (const Index f : faces_[part]) {
    Face face = mesh_.faces[f];
    for (Index& v : face) {
      const auto [entry, is_new] =
          numbers.try_emplace(v, static_cast<Index>(result.positions.size()));
      if (is_new) result.positions.push_back(mesh_.positions[v]);
      v = entry->second;
    }
    result.faces.push_back(face);
  }
  return result;
}

// Calls `vote` for about `voters` vertices of component `inner`. If no vertex has a vote, as in a
// cavity that touches its body at each vertex, calls it for the middles of their faces. True if
// `vote` returns true more often than false.
bool Bodies::most_vote(Index inner,
                       const std::function<std::optional<bool>(const Vec3&)>& vote) const {
  std::size_t yes = 0, no = 0;
  const std::size_t stride = std::max<std::size_t>(1, faces_[inner].size() / voters);
  const auto ask = [&](const auto& point_of) {
    for (std::size_t i = 0; i < faces_[inner].size(); i += stride) {
      const auto answer = vote(point_of(faces_[inner][i]));
      if (answer) ++(*answer ? yes : no);
    }
  };
  ask([&](Index face) { return mesh_.positions[mesh_.faces[face][0]]; });
  if (yes + no == 0) ask([&](Index face) { return face_middle(mesh_, face); });
  return yes > no;
}

// Calls visit(inner) for each other component whose bounding box is inside the bounding box of
// `outer`.
template <class Visit>
void Bodies::for_each_within(Index outer, const Visit& visit) const {
  const Box& box = boxes_[outer];
  tree_.visit_overlaps(frame_.box(box.min(), box.max()), [&](Index inner) {
    if (inner != outer && box.contains(boxes_[inner])) visit(inner);
    return true;
  });
}

// Returns for each component the closed components that contain it.
std::vector<std::vector<Index>> Bodies::containers() const {
  std::vector<std::vector<Index>> around(faces_.size());
  for (Index outer = 0; outer < faces_.size(); ++outer) {
    if (!is_closed(outer)) continue;
    std::optional<RayCastWinding> winding;
    Mesh outer_mesh;
    for_each_within(outer, [&](Index inner) {
      // A copy of a component is not inside of it.
      if (is_closed(inner) && std::abs(volume(inner)) >= std::abs(volume(outer))) return;
      if (!winding) {
        outer_mesh = mesh_of(outer);
        winding.emplace(outer_mesh);
      }
      const auto is_inside = [&](const Vec3& point) -> std::optional<bool> {
        const std::optional<int> number = (*winding)(point);
        return number ? std::optional(*number != 0) : std::nullopt;
      };
      if (most_vote(inner, is_inside)) around[inner].push_back(outer);
    });
  }
  return around;
}

// Removes from `inners` each component that is inside a component with borders. The generalized
// winding number of the component with borders decides.
void Bodies::erase_enclosed(std::vector<Index>& inners) const {
  for (Index outer = 0; outer < faces_.size(); ++outer) {
    if (is_closed(outer)) continue;
    std::optional<WindingHierarchy> winding;
    Mesh outer_mesh;
    std::erase_if(inners, [&](Index inner) {
      if (!boxes_[outer].contains(boxes_[inner])) return false;
      if (!winding) {
        outer_mesh = mesh_of(outer);
        winding.emplace(outer_mesh);
      }
      return most_vote(inner, [&](const Vec3& point) -> std::optional<bool> {
        return std::abs((*winding)(point)) > 0.5;
      });
    });
  }
}

// Returns 1 for each component of a body that is inside out. An outermost component, which no other
// component contains, defines a body. A component inside several outermost components belongs to
// the smallest of these bodies.
std::vector<char> Bodies::inward() const {
  const std::vector<std::vector<Index>> around = containers();
  std::vector<char> is_inward(around.size(), 0);
  std::vector<Index> roots;
  for (Index part = 0; part < around.size(); ++part)
    if (is_negative_[part] && around[part].empty()) roots.push_back(part);
  erase_enclosed(roots);
  for (const Index part : roots) is_inward[part] = 1;
  for (Index part = 0; part < around.size(); ++part) {
    Index root = no_index;
    for (const Index outer : around[part])
      if (around[outer].empty() &&
          (root == no_index || std::abs(volume(outer)) < std::abs(volume(root))))
        root = outer;
    if (root != no_index) is_inward[part] = is_inward[root];
  }
  return is_inward;
}

std::vector<char> Bodies::against_nesting() const {
  const std::vector<std::vector<Index>> around = containers();
  std::vector<char> is_wrong(around.size(), 0);
  for (Index part = 0; part < around.size(); ++part) {
    const bool is_cavity = around[part].size() % 2 == 1;
    is_wrong[part] = is_closed(part) && is_negative_[part] != is_cavity ? 1 : 0;
  }
  return is_wrong;
}

bool Bodies::any_in_body() const {
  const std::vector<std::vector<Index>> around = containers();
  for (Index part = 0; part < around.size(); ++part) {
    int winding = 0;
    for (const Index outer : around[part]) winding += is_negative_[outer] ? -1 : 1;
    const bool is_inside = is_closed(part) && !around[part].empty();
    if (is_inside && winding != is_negative_[part]) return true;
  }
  return false;
}

std::size_t turn(Mesh& mesh, const Bodies& bodies, const std::vector<char>& is_turned) {
  std::size_t turned = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!is_turned[bodies.of_face(f)]) continue;
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
    reverse_corner_lists(mesh, f);
    ++turned;
  }
  return turned;
}

}  // namespace

bool has_inward_bodies(const Mesh& mesh) {
  const Bodies bodies(mesh);
  return bodies.any_negative() && std::ranges::count(bodies.inward(), 1) > 0;
}

bool has_bodies_in_bodies(const Mesh& mesh) { return Bodies(mesh).any_in_body(); }

std::size_t turn_bodies_outwards(Mesh& mesh) {
  const Bodies bodies(mesh);
  return bodies.any_negative() ? turn(mesh, bodies, bodies.inward()) : 0;
}

std::size_t turn_nested_alternately(Mesh& mesh) {
  const Bodies bodies(mesh);
  return turn(mesh, bodies, bodies.against_nesting());
}

}  // namespace transformesh
