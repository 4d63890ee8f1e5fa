#include "clean/flat/flat_outlines.h"

#include <algorithm>
#include <array>

#include "clean/rounding/triangle_distance.h"
#include "mesh/coordinate_spacing.h"

namespace transformesh {
namespace {

double distance_from_segment(const Vec3& a, const Vec3& b, const Vec3& point) {
  const LineDistance found = distance_from_line(a, b, point);
  return found.beyond <= 0 ? found.distance
                           : Eigen::Vector2d(found.distance, found.beyond).stableNorm();
}

}  // namespace

FlatOutlines::FlatOutlines(const FlatSurface& surface, std::span<const Index> of_face)
    : surface_(surface),
      of_face_(of_face),
      places_(surface.mesh.positions.size(), nowhere),
      goes_(surface.mesh.positions.size(), 0),
      is_followed_(3 * surface.mesh.faces.size(), 0) {
  find_places();
  straighten_edges();
}

Index FlatOutlines::region_across(Index halfedge) const {
  const Index across = surface_.opposites[halfedge];
  return across == no_index ? no_index : of_face_[across / 3];
}

bool FlatOutlines::is_outline(Index halfedge) const {
  return region_across(halfedge) != of_face_[halfedge / 3];
}

/// Sets the place of each vertex. The place is `on_edge` if exactly two outline edges meet at the
/// vertex, all its faces belong to regions, and no other vertex has its position.
void FlatOutlines::find_places() {
  const std::vector<Face>& faces = surface_.mesh.faces;
  std::vector<char> edges(places_.size(), 0);
  const auto count = [&](Index v) { edges[v] = static_cast<char>(std::min(edges[v] + 1, 3)); };
  for (Index f = 0; f < faces.size(); ++f) {
    if (of_face_[f] == no_index) continue;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      places_[faces[f][h % 3]] = inside;
      const Index across = surface_.opposites[h];
      if (!is_outline(h) || (across != no_index && of_face_[across / 3] != no_index && across < h))
        continue;
      count(halfedge_source(surface_.mesh, h));
      count(halfedge_target(surface_.mesh, h));
    }
  }
  for (std::size_t v = 0; v < places_.size(); ++v)
    if (edges[v] > 0) places_[v] = edges[v] == 2 && !surface_.has_copy[v] ? on_edge : corner;
  for (Index f = 0; f < faces.size(); ++f)
    if (of_face_[f] == no_index)
      for (const Index v : faces[f]) places_[v] = corner;
  for (std::size_t v = 0; v < places_.size(); ++v)
    goes_[v] = places_[v] == inside && !surface_.has_copy[v] ? 1 : 0;
}

/// Returns the halfedge that follows a halfedge of an outline on the same outline.
Index FlatOutlines::next_around(Index halfedge) const {
  Index next = next_halfedge(halfedge);
  while (!is_outline(next)) next = next_halfedge(surface_.opposites[next]);
  return next;
}

/// Returns a row: the vertices of an outline from the source of a halfedge to the next vertex whose
/// place is `corner`. If there is no such vertex, the row ends where it starts.
std::vector<Index> FlatOutlines::row_from(Index halfedge) const {
  std::vector<Index> row{halfedge_source(surface_.mesh, halfedge)};
  for (Index at = halfedge;; at = next_around(at)) {
    row.push_back(halfedge_target(surface_.mesh, at));
    if (places_[row.back()] == corner || row.back() == row.front()) return row;
  }
}

/// Removes vertices on straight parts of all outlines. Rows of vertices between two corners are
/// processed first, then outlines without corners.
void FlatOutlines::straighten_edges() {
  std::vector<char> is_done(places_.size(), 0);
  const auto straighten_from = [&](Index halfedge) {
    std::vector<Index> row = row_from(halfedge);
    if (row.size() < 3 || is_done[row[1]]) return;
    if (places_[row.front()] == on_edge) begin_at_corner(row);
    for (std::size_t i = 1; i + 1 < row.size(); ++i) is_done[row[i]] = 1;
    is_done[row.front()] = 1;
    straighten(row);
  };
  for (const bool from_corners : {true, false})
    for (Index h = 0; h < is_followed_.size(); ++h) {
      if (of_face_[h / 3] == no_index || !is_outline(h)) continue;
      const Index source = halfedge_source(surface_.mesh, h);
      if (from_corners ? places_[source] == corner : !is_done[source] && places_[source] == on_edge)
        straighten_from(h);
    }
}

/// Rotates a closed row of vertices such that it starts at the vertex farthest from its first
/// vertex. The farthest vertex is never on a straight line between its neighbors.
void FlatOutlines::begin_at_corner(std::vector<Index>& row) const {
  row.pop_back();
  const Vec3& first = surface_.mesh.positions[row.front()];
  const auto is_nearer = [&](Index a, Index b) {
    return (surface_.mesh.positions[a] - first).stableNorm() <
           (surface_.mesh.positions[b] - first).stableNorm();
  };
  std::rotate(row.begin(), std::max_element(row.begin(), row.end(), is_nearer), row.end());
  row.push_back(row.front());
}

/// Marks the vertices of a row that are removed (Douglas & Peucker). The row is recursively split
/// at the vertex farthest from the segment between its ends, until all vertices are within the
/// tolerance. A closed row is first split at the vertex farthest from its start.
void FlatOutlines::straighten(const std::vector<Index>& row) {
  const auto at = [&](std::size_t i) { return surface_.mesh.positions[row[i]]; };
  for (std::size_t i = 1; i + 1 < row.size(); ++i) goes_[row[i]] = 1;
  std::vector<std::array<std::size_t, 2>> parts{{0, row.size() - 1}};
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    std::size_t farthest = first;
    double most = 0;
    bool is_straight = true;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = row[first] == row[last]
                                  ? (at(i) - at(first)).stableNorm()
                                  : distance_from_segment(at(first), at(last), at(i));
      if (distance > surface_.spacings * spacing_around(at(i), surface_.coordinate))
        is_straight = false;
      if (!(distance > most)) continue;
      most = distance;
      farthest = i;
    }
    if (is_straight) {
      movement_ = std::max(movement_, most);
      continue;
    }
    goes_[row[farthest]] = 0;
    parts.push_back({first, farthest});
    parts.push_back({farthest, last});
  }
}

bool FlatOutlines::changes(const FlatRegion& region) const {
  return std::any_of(region.faces.begin(), region.faces.end(), [&](Index face) {
    const auto& [a, b, c] = surface_.mesh.faces[face];
    return goes(a) || goes(b) || goes(c);
  });
}

void FlatOutlines::follow(Index halfedge, RegionOutlines& found) {
  std::vector<Index> outline;
  for (Index at = halfedge; !is_followed_[at]; at = next_around(at)) {
    is_followed_[at] = 1;
    const Index v = halfedge_source(surface_.mesh, at);
    if (goes(v))
      --found.faces;
    else
      outline.push_back(v);
  }
  if (!outline.empty()) found.outlines.push_back(std::move(outline));
}

RegionOutlines FlatOutlines::of(const FlatRegion& region) {
  RegionOutlines found{{}, region.faces.size()};
  std::vector<Index> inner;
  for (const Index face : region.faces)
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index from = halfedge_source(surface_.mesh, h);
      const Index to = halfedge_target(surface_.mesh, h);
      if (is_outline(h))
        follow(h, found);
      else if (surface_.has_copy[from] && surface_.has_copy[to] && from < to)
        found.outlines.push_back({from, to});
      if (places_[from] == inside) inner.push_back(from);
    }
  std::sort(inner.begin(), inner.end());
  inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
  for (const Index v : inner)
    if (goes(v))
      found.faces -= 2;
    else
      found.outlines.push_back({v});
  return found;
}

}  // namespace transformesh
