#include "clean/stitch/double_sided.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "clean/stitch/weld.h"
#include "geometry/inward_components.h"
#include "mesh/disjoint_sets.h"
#include "mesh/drop_faces.h"
#include "mesh/edges.h"
#include "mesh/surface_columns.h"
#include "transformesh/components.h"

namespace transformesh {
namespace {

/// A face with its corners in ascending order.
struct SortedFace {
  Face corners;
  Index face;
  bool is_odd;  ///< true if sorting the corners reversed the orientation

  auto key() const { return std::tie(corners, face); }
};

SortedFace sorted_face(const Face& v, Index face) {
  SortedFace sorted{v, face, false};
  std::sort(sorted.corners.begin(), sorted.corners.end());
  const auto at = std::find(v.begin(), v.end(), sorted.corners[0]) - v.begin();
  sorted.is_odd = v[static_cast<std::size_t>(at + 1) % 3] != sorted.corners[1];
  return sorted;
}

// Calls visit(first, last) for each set of faces with the same three corners. The arguments are a
// range of SortedFace.
template <class Visit>
void visit_coincident(const std::vector<Face>& faces, const Visit& visit) {
  std::vector<SortedFace> sorted;
  for (Index f = 0; f < faces.size(); ++f)
    if (!is_collapsed(faces[f])) sorted.push_back(sorted_face(faces[f], f));
  std::sort(sorted.begin(), sorted.end(),
            [](const SortedFace& a, const SortedFace& b) { return a.key() < b.key(); });
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(), [&](const SortedFace& other) {
      return other.corners != first->corners;
    });
    visit(first, last);
    first = last;
  }
}

// Calls visit(first, last) for each set of faces with the same three corners in which both
// orientations occur.
template <class Visit>
void visit_double_sided(const std::vector<Face>& faces, const Visit& visit) {
  visit_coincident(faces, [&](auto first, auto last) {
    const bool is_double = std::any_of(
        first, last, [&](const SortedFace& other) { return other.is_odd != first->is_odd; });
    if (is_double) visit(first, last);
  });
}

// Returns the faces of the mesh after vertices within the tolerance are merged.
std::vector<Face> welded_faces(const Mesh& mesh, double tolerance) {
  const std::vector<Index> joined = weld_positions(mesh.positions, tolerance);
  std::vector<Face> faces = mesh.faces;
  for (Face& face : faces)
    for (Index& v : face) v = joined[v];
  return faces;
}

// Returns the number of edges with an odd number of faces.
std::size_t count_odd(const Edges& edges) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) count += edges.halfedges(e).size() % 2;
  return count;
}

// True if there is a connected set of faces without single faces: each face coincides with another
// face, and at least two coincident faces have opposite orientations.
bool has_double_part(const std::vector<Face>& faces, const Edges& edges) {
  DisjointSets parts(faces.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const Index h : edges.halfedges(e)) parts.join(h / 3, edges.halfedges(e).front() / 3);
  std::vector<char> has_single(faces.size(), 0), has_reverse(faces.size(), 0);
  visit_coincident(faces, [&](auto first, auto last) {
    if (last - first == 1) has_single[parts.find(first->face)] = 1;
  });
  visit_double_sided(faces, [&](auto first, auto) { has_reverse[parts.find(first->face)] = 1; });
  for (Index f = 0; f < faces.size(); ++f)
    if (has_reverse[f] && !has_single[f]) return true;
  return false;
}

/// Returns 1 for each face of a wall between bodies. `original` has the first of copies of each
/// face that has copies, or no_index. A wall is a connected set of copies that ends only at edges
/// with an even number of other faces: without the wall, these faces are neighbors. Other copies
/// end at edges with an odd number of other faces.
std::vector<char> walls(const Mesh& mesh, const std::vector<Index>& original) {
  std::vector<char> is_wall(mesh.faces.size(), 0);
  DisjointSets parts(mesh.faces.size());
  std::vector<char> ends_even(mesh.faces.size(), 0), ends_odd = ends_even;
  const Edges edges(without_collapsed(mesh.faces), mesh.positions.size());
  const auto visit_edges = [&](const auto& visit) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      std::vector<Index> copies;
      for (const Index h : edges.halfedges(e))
        if (original[h / 3] != no_index) copies.push_back(original[h / 3]);
      const std::size_t others = edges.halfedges(e).size() - copies.size();
      std::ranges::sort(copies);
      copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
      if (!copies.empty()) visit(copies, others);
    }
  };
  visit_edges([&](const std::vector<Index>& copies, std::size_t others) {
    if (others == 0 && copies.size() == 2) parts.join(copies[0], copies[1]);
  });
  visit_edges([&](const std::vector<Index>& copies, std::size_t others) {
    for (const Index f : copies)
      if (others > 0) (others % 2 == 0 ? ends_even : ends_odd)[parts.find(f)] = 1;
  });
  for (Index f = 0; f < is_wall.size(); ++f) {
    if (original[f] == no_index) continue;
    const Index part = parts.find(original[f]);
    is_wall[f] = ends_even[part] && !ends_odd[part] ? 1 : 0;
  }
  return is_wall;
}

}  // namespace

std::size_t count_double_sided(const Mesh& mesh) {
  const std::vector<Face> faces = welded_faces(mesh, 0);
  std::size_t count = 0;
  visit_double_sided(
      faces, [&](auto first, auto last) { count += static_cast<std::size_t>(last - first); });
  return count;
}

bool needs_one_side(const Mesh& mesh, double tolerance) {
  Mesh welded{mesh.positions, without_collapsed(welded_faces(mesh, tolerance)), {}, {}};
  const Edges edges(welded);
  if (has_double_part(welded.faces, edges)) return true;
  Mesh both = welded;
  if (drop_reverses(welded) == 0) return false;
  drop_copies(welded);
  drop_copies(both);
  return count_odd(Edges(welded)) < std::min(count_odd(edges), count_odd(Edges(both)));
}

bool one_side_is_open(const Mesh& mesh) {
  Mesh one{mesh.positions, welded_faces(mesh, 0), {}, {}};
  drop_reverses(one);
  const Edges edges(without_collapsed(one.faces), one.positions.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges.halfedges(e).size() == 1) return true;
  return false;
}

std::size_t drop_reverses(Mesh& mesh) {
  std::vector<char> is_dropped(mesh.faces.size(), 0);
  visit_double_sided(mesh.faces, [&](auto first, auto last) {
    for (auto other = first + 1; other != last; ++other) is_dropped[other->face] = 1;
  });
  return drop_faces(mesh, is_dropped);
}

std::size_t drop_copies(Mesh& mesh, bool drops_walls) {
  std::vector<Index> original(mesh.faces.size(), no_index);
  visit_coincident(mesh.faces, [&](auto first, auto last) {
    std::array<Index, 2> firsts{no_index, no_index};
    for (; first != last; ++first) {
      Index& of_direction = firsts.at(first->is_odd);
      if (of_direction == no_index) {
        of_direction = first->face;
        continue;
      }
      original[first->face] = original[of_direction] = of_direction;
    }
  });
  std::vector<char> is_dropped(mesh.faces.size(), 0);
  if (drops_walls) is_dropped = walls(mesh, original);
  for (Index f = 0; f < original.size(); ++f)
    if (original[f] != no_index && original[f] != f) is_dropped[f] = 1;
  return drop_faces(mesh, is_dropped);
}

std::size_t turn_outwards(Mesh& mesh) {
  const Components all = connected_components(mesh);
  const std::vector<char> is_inward = inward_components(mesh, all);
  std::size_t turned = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!is_inward[all.of_face[f]]) continue;
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
    reverse_corner_lists(mesh, static_cast<Index>(f));
    ++turned;
  }
  return turned;
}

}  // namespace transformesh
