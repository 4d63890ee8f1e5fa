#include "repair/crack_tolerance.h"

#include <algorithm>
#include <cmath>

#include "clean/stitch/border_edges.h"
#include "clean/stitch/double_sided.h"
#include "clean/stitch/split_border_edges.h"
#include "clean/stitch/weld.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/edges.h"
#include "mesh/local_measures.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// A crack must be narrower than other lengths of the mesh: the next larger border distance, and
/// nearly all edges, are at least this many times the crack width. The ratio is in the thousands at
/// cracks that rounded coordinates cause. With a lower limit, narrow slots would count as cracks;
/// with a much higher limit, cracks in finely meshed files with six digits would be missed.
constexpr double clear_gap = 8;

/// Largest crack width as a share of the bounding box diagonal. Files with four digits have cracks
/// of 1e-4. With a limit of 1e-3, the two sides of thin walls without rim faces would be joined.
constexpr double widest_crack = 2e-4;

/// Largest ratio of the number of edges that may collapse to the number of vertices at cracks.
/// Edges up to `clear_gap` times the crack width may collapse. If more edges are that short, the
/// width is a distance within the mesh, not of a crack.
constexpr double lost_edges = 0.1;

/// Cosine of 25 degrees. Two faces at an edge fold back if the angle between them is smaller. With
/// a larger angle, sharp edges would count as rims of plates.
constexpr double folded_back = 0.9;

/// A mesh whose positions within a tolerance are one vertex. Faces that lose a corner are removed.
struct JoinedMesh {
  Mesh mesh;
  std::vector<Index> face_source;  ///< for each face the face before joining
};

JoinedMesh joined(const Mesh& mesh, double tolerance) {
  const std::vector<Index> first = weld_positions(mesh.positions, tolerance);
  JoinedMesh result{{mesh.positions, {}, {}, {}}, {}};
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Face face = {first[a], first[b], first[c]};
    if (is_collapsed(face)) continue;
    result.mesh.faces.push_back(face);
    result.face_source.push_back(f);
  }
  return result;
}

/// Splits border edges at vertices that lie on them.
void split_borders(JoinedMesh& joined, double tolerance) {
  for (const Index f : split_border_edges(joined.mesh, tolerance).face_source)
    joined.face_source.push_back(joined.face_source[f]);
}

struct Distance {
  double length;
  Vec3 place;
};

struct Lengths {
  std::vector<double> edges;  ///< lengths of all edges, ascending
  /// Distances of border vertices from the nearest border edges, ascending.
  std::vector<Distance> borders;
};

std::vector<double> lengths_of(const Mesh& mesh, const Edges& edges) {
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Index h = edges.halfedges(e)[0];
    lengths.push_back(
        (mesh.positions[halfedge_source(mesh, h)] - mesh.positions[halfedge_target(mesh, h)])
            .norm());
  }
  std::ranges::sort(lengths);
  return lengths;
}

/// Returns the distance of each border vertex from the nearest border edge that does not end in it,
/// but at most `farthest`.
std::vector<Distance> border_distances(const Mesh& mesh, const BorderEdges& borders,
                                       double farthest) {
  std::vector<Distance> distances;
  for (const Index v : borders.vertices()) {
    double nearest = farthest;
    borders.visit_near(v, farthest, [&](const BorderEdges::Near& near) {
      nearest = std::min(nearest, near.distance);
    });
    distances.push_back({nearest, mesh.positions[v]});
  }
  std::ranges::stable_sort(distances, {}, &Distance::length);
  return distances;
}

std::size_t count_up_to(const std::vector<double>& sorted, double length) {
  return static_cast<std::size_t>(std::ranges::upper_bound(sorted, length) - sorted.begin());
}

/// Returns the largest distance of border vertices from borders that can be a crack width: it is
/// clearly shorter than the next larger distance and than almost all edges. Distances below `least`
/// count as `least`.
Cracks widest_clear(const Lengths& lengths, double least, double diagonal) {
  Cracks found;
  const auto& borders = lengths.borders;
  for (std::size_t k = 0; k < borders.size(); ++k) {
    const double width = std::max(least, borders[k].length);
    if (width > widest_crack * diagonal) break;
    const std::size_t shorter = count_up_to(lengths.edges, clear_gap * width);
    double next = k + 1 < borders.size() ? borders[k + 1].length : diagonal;
    if (shorter < lengths.edges.size()) next = std::min(next, lengths.edges[shorter]);
    const bool is_clear = next >= clear_gap * width;
    if (!is_clear || static_cast<double>(shorter) > lost_edges * static_cast<double>(k + 1))
      continue;
    found = {width, width * std::min(4.0, std::sqrt(next / width)), k + 1, borders[k].place};
  }
  return found;
}

bool share_edge(const Face& f, const Face& g) {
  const auto is_shared = [&](Index v) { return std::ranges::find(g, v) != g.end(); };
  return std::ranges::count_if(f, is_shared) >= 2;
}

/// Returns the halfedges of an edge without those whose faces coincide with a face of an earlier
/// one, as in copies of a body.
std::vector<Index> distinct_sides(const Mesh& mesh, std::span<const Index> halfedges) {
  std::vector<Index> sides, corners;
  for (const Index h : halfedges) {
    const Index corner = halfedge_source(mesh, previous_halfedge(h));
    if (std::ranges::find(corners, corner) != corners.end()) continue;
    corners.push_back(corner);
    sides.push_back(h);
  }
  return sides;
}

/// True if the surface continues across at least half of the border edges that joining closes, and
/// joining closes any. At the other edges the two faces fold back, as at the rim of a thin plate,
/// or where bodies touch.
bool continues(const Mesh& before, const JoinedMesh& after) {
  const Edges edges(after.mesh);
  std::size_t straight = 0, folded = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::vector<Index> sides = distinct_sides(after.mesh, edges.halfedges(e));
    if (sides.size() != 2) continue;
    const Index f = after.face_source[sides[0] / 3], g = after.face_source[sides[1] / 3];
    if (share_edge(before.faces[f], before.faces[g])) continue;
    const double cosine =
        direction_into_face(after.mesh, sides[0]).dot(direction_into_face(after.mesh, sides[1]));
    ++(cosine > folded_back ? folded : straight);
  }
  return straight > 0 && straight >= folded;
}

}  // namespace

Cracks find_cracks(const Mesh& mesh) {
  // Copies of a body with cracks would hide its borders.
  Mesh exact = joined(mesh, 0).mesh;
  drop_copies(exact);
  drop_reverses(exact);
  const BorderEdges borders(exact);
  if (borders.vertices().size() < 2) return {};
  const double diagonal = diagonal_of(bounding_box(mesh));
  const Edges edges(exact);
  const Lengths lengths{lengths_of(exact, edges),
                        border_distances(exact, borders, clear_gap * widest_crack * diagonal)};
  const Cracks found = widest_clear(lengths, coordinate_spacing(mesh), diagonal);
  if (found.tolerance == 0) return {};
  JoinedMesh closed = joined(exact, found.tolerance);
  split_borders(closed, found.tolerance);
  return continues(exact, closed) ? found : Cracks();
}

}  // namespace transformesh
