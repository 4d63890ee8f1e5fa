#include "fill/contact_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "fill/hole_patch.h"
#include "fill/hole_triangulation.h"
#include "mesh/adjacency.h"
#include "mesh/triangle.h"

namespace transformesh {
namespace {

/// Least mean cosine of the angles between the faces at a loop and its patch. The patch of a tongue
/// of faces that extends into a hole is on the tongue. Its cosine is -1 if the tongue is flat, and
/// -0.71 if it bends around an edge of a cube. The cosine is 0 at a hemisphere, -0.33 at a regular
/// tetrahedron without a face, and positive at small holes of bodies.
constexpr double least_facing = -0.5;

/// Largest ratio of the area of two patches to that of one patch for both. It is 2 for long edges
/// if the missing faces have an angle of 60 degrees, and it is large if a crack surrounds a body
/// except at one edge.
constexpr double largest_ratio = 2;

/// Returns the mean cosine of the angles between the normals of the faces at a loop, weighted by
/// the lengths of their edges, and the normal of the loop. Leaves out the first edge of the loop,
/// where a narrow wedge may touch another body.
double facing_of(const Mesh& mesh, const HoleLoop& loop) {
  const auto ends = [&](Index h) {
    return std::pair(mesh.positions[halfedge_source(mesh, h)],
                     mesh.positions[halfedge_target(mesh, h)]);
  };
  const Vec3 origin = ends(loop.front()).first;
  Vec3 normal = Vec3::Zero(), faces = Vec3::Zero();
  double length = 0;
  for (const Index h : loop) {
    const auto [source, target] = ends(h);
    normal -= normal_of(origin, source, target);
    if (h == loop.front()) continue;
    const auto& [a, b, c] = triangle_of(mesh, h / 3);
    const double edge = (target - source).stableNorm();
    faces += edge * normal_of(a, b, c).stableNormalized();
    length += edge;
  }
  return faces.dot(normal.stableNormalized()) / length;
}

/// Returns the area of a patch without the inner edges `chords`; infinite if there is none.
double area_of_patch(const Mesh& mesh, const HoleLoop& loop,
                     std::vector<std::pair<Index, Index>> chords = {}) {
  HoleBorder border;
  border.chords = std::move(chords);
  for (const Index h : loop) {
    border.points.push_back(mesh.positions[halfedge_source(mesh, h)]);
    border.across.push_back(mesh.positions[halfedge_source(mesh, previous_halfedge(h))]);
  }
  const std::vector<HoleTriangle> triangles =
      loop.size() <= most_edges_of_all ? least_triangulation(border) : sparse_triangulation(border);
  double area = triangles.empty() ? std::numeric_limits<double>::infinity() : 0;
  for (const auto& [i, m, k] : triangles)
    area += normal_of(border.points[i], border.points[m], border.points[k]).stableNorm() / 2;
  return area;
}

/// An edge of the mesh between two vertices of a loop that are not neighbors on the loop.
struct Chord {
  Index halfedge;
  std::pair<Index, Index> places;  ///< places of source and target on the loop, ascending
};

/// The part of a loop from one place to another, closed by a halfedge of a chord.
struct LoopPart {
  Index closing, from, to;
};

HoleLoop loop_of(const LoopPart& part, const HoleLoop& loop) {
  HoleLoop result{part.closing};
  const auto size = static_cast<Index>(loop.size());
  for (Index i = part.from; i != part.to; i = (i + 1) % size) result.push_back(loop[i]);
  return result;
}

class ContactCutter {
 public:
  ContactCutter(Mesh& mesh, const std::function<bool(const HoleLoop&)>& may_fill)
      : mesh_(mesh), may_fill_(may_fill), opposites_(opposite_halfedges(mesh)) {}

  /// Cuts the loop at an edge, and returns the other loop. Returns nothing if no edge is cut.
  std::optional<HoleLoop> cut(HoleLoop& loop);

 private:
  std::vector<Index> leaving_from(Index border_halfedge) const;
  std::vector<Chord> chords_of(const HoleLoop& loop);
  std::vector<Index> corners_to_move(Index chord, const HoleLoop& loop, Index place) const;
  void move_corners(const std::vector<Index>& corners);

  Mesh& mesh_;
  const std::function<bool(const HoleLoop&)>& may_fill_;
  std::vector<Index> opposites_;
  std::vector<Index> place_;  ///< for each vertex, its place on the loop
};

/// Returns halfedges that leave the same vertex, in the order of their faces: from the given one to
/// the last one in its umbrella.
std::vector<Index> ContactCutter::leaving_from(Index first) const {
  std::vector<Index> leaving{first};
  for (Index h = first; (h = opposites_[previous_halfedge(h)]) != no_index;) leaving.push_back(h);
  return leaving;
}

/// Finds chords in the umbrellas at which the loop arrives or leaves.
std::vector<Chord> ContactCutter::chords_of(const HoleLoop& loop) {
  const auto size = static_cast<Index>(loop.size());
  std::vector<std::vector<Index>> leaving;
  place_.resize(mesh_.positions.size(), no_index);
  for (Index i = 0; i < size; ++i) {
    std::vector<Index>& all = leaving.emplace_back(leaving_from(loop[i]));
    place_[halfedge_source(mesh_, loop[i])] = i;
    const Index arriving = loop[(i + size - 1) % size];
    if (previous_halfedge(all.back()) == arriving) continue;
    Index first = next_halfedge(arriving);
    while (opposites_[first] != no_index) first = next_halfedge(opposites_[first]);
    for (const Index h : leaving_from(first)) all.push_back(h);
  }
  std::vector<Chord> chords;
  for (Index i = 0; i < size; ++i)
    for (const Index h : leaving[i]) {
      const Index k = place_[halfedge_target(mesh_, h)];
      if (k == no_index || k <= i + 1 || (i == 0 && k + 1 == size)) continue;
      if (std::ranges::find(leaving[k], opposites_[h]) != leaving[k].end())
        chords.push_back({h, {i, k}});
    }
  for (const Index h : loop) place_[halfedge_source(mesh_, h)] = no_index;
  return chords;
}

std::optional<HoleLoop> ContactCutter::cut(HoleLoop& loop) {
  const std::vector<Chord> chords = chords_of(loop);
  std::vector<std::pair<Index, Index>> inner;
  for (const Chord& chord : chords) inner.push_back(chord.places);
  std::ranges::sort(inner);
  const auto is_of_body = [&](const LoopPart& part) {
    const HoleLoop edges = loop_of(part, loop);
    return may_fill_(edges) && facing_of(mesh_, edges) >= least_facing;
  };
  std::optional<double> whole;
  for (const auto& [h, places] : chords) {
    LoopPart shorter{opposites_[h], places.first, places.second};
    LoopPart longer{h, places.second, places.first};
    if (2 * (places.second - places.first) > loop.size()) std::swap(shorter, longer);
    // The shorter part alone rejects a tongue of faces, of which a ragged border has many.
    if (!is_of_body(shorter) || !is_of_body(longer)) continue;
    HoleLoop one = loop_of(longer, loop), other = loop_of(shorter, loop);
    if (!whole) whole = area_of_patch(mesh_, loop, inner);
    const double both = area_of_patch(mesh_, one) + area_of_patch(mesh_, other);
    if (!(both > 0 && both <= largest_ratio * *whole)) continue;  // areas may underflow
    const std::vector<Index> at_source = corners_to_move(h, loop, places.first);
    move_corners(corners_to_move(opposites_[h], loop, places.second));
    move_corners(at_source);
    opposites_[opposites_[h]] = no_index;
    opposites_[h] = no_index;
    loop = std::move(one);
    return other;
  }
  return std::nullopt;
}

/// Returns the corners at the source of a chord, on the side whose faces are between the chord and
/// the loop. Faces of the umbrella on the other side may be at another hole that touches the loop.
std::vector<Index> ContactCutter::corners_to_move(Index chord, const HoleLoop& loop,
                                                  Index place) const {
  std::vector<Index> corners = leaving_from(chord);
  if (previous_halfedge(corners.back()) == loop[(place + loop.size() - 1) % loop.size()])
    return corners;
  corners = leaving_from(loop[place]);
  corners.erase(std::ranges::find(corners, chord), corners.end());
  return corners;
}

/// Gives these corners a copy of their vertex.
void ContactCutter::move_corners(const std::vector<Index>& corners) {
  const Index vertex = halfedge_source(mesh_, corners.front());
  mesh_.vertex_columns.append({{vertex, vertex, vertex}, {1, 0, 0}});
  for (const Index corner : corners)
    mesh_.faces[corner / 3][corner % 3] = static_cast<Index>(mesh_.positions.size());
  mesh_.positions.push_back(Vec3(mesh_.positions[vertex]));
}

}  // namespace

std::size_t cut_contact_edges(Mesh& mesh, std::vector<Face>& separate, std::vector<HoleLoop>& loops,
                              const std::function<bool(const HoleLoop&)>& may_fill) {
  const std::size_t before = loops.size(), vertices = mesh.positions.size();
  if (before == 0) return 0;
  ContactCutter cutter(mesh, may_fill);
  for (std::size_t i = 0; i < loops.size(); ++i)
    while (std::optional<HoleLoop> other = cutter.cut(loops[i])) loops.push_back(std::move(*other));
  for (Index h = 0; h < 3 * mesh.faces.size(); ++h)
    if (const Index v = mesh.faces[h / 3][h % 3]; v >= vertices) separate[h / 3][h % 3] = v;
  return loops.size() - before;
}

}  // namespace transformesh
