#include "fill/twin_patches.h"

#include <algorithm>

#include "fill/hole_neighborhood.h"
#include "mesh/coordinate_spacing.h"

namespace transformesh {
namespace {

std::vector<Index> sorted_faces(const SlitSide& side) {
  std::vector<Index> faces;
  for (const std::vector<Index>& corners : side.corners)
    for (const Index corner : corners) faces.push_back(corner / 3);
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Returns the faces within two rings of the loop, except the faces at the loop on its right side.
/// Hence the loop is the border of a hole in these faces.
std::vector<Index> faces_on_left(const Mesh& mesh, const std::vector<Index>& loop,
                                 const SlitSides& sides, const HalfedgeStars& stars) {
  std::vector<Index> faces = faces_around(mesh, loop, [&](Index v, std::vector<Index>& all) {
    stars.visit(v, [&](Index h) { all.push_back(h / 3); });
  });
  const std::vector<Index> right = sorted_faces(sides.right);
  std::erase_if(faces, [&](Index f) { return std::binary_search(right.begin(), right.end(), f); });
  return faces;
}

/// True if an edge of the patch already exists on a side of the slit, as an edge between vertices
/// that are not consecutive on the loop.
bool has_chord(const HolePatch& patch, const SlitSides& sides) {
  const auto is_chord = [](const SlitSide& side, Index from, Index to) {
    const std::pair chord(from, to);
    return std::find(side.chords.begin(), side.chords.end(), chord) != side.chords.end();
  };
  for (const Face& face : patch.faces)
    for (int i = 0; i < 3; ++i) {
      const Index from = face.at(i), to = face.at((i + 1) % 3);
      if (is_chord(sides.left, from, to) || is_chord(sides.right, from, to)) return true;
    }
  return false;
}

/// Replaces vertex indices of the neighborhood mesh by vertex indices of the whole mesh. The
/// additional points of the patch follow the `vertices` vertices of the whole mesh.
void rename(HolePatch& patch, const HoleNeighborhood& part, std::size_t vertices) {
  const auto known = static_cast<Index>(part.vertices.size());
  for (Face& face : patch.faces)
    for (Index& v : face)
      v = v < known ? part.vertices[v] : static_cast<Index>(vertices) + v - known;
}

DrawnSide drawn(const Mesh& mesh, const std::vector<Index>& loop, const SlitSide& side,
                const HolePatch& patch, Scalar coordinate) {
  DrawnSide drawn;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    mean += (side.drawn_back[i] - mesh.positions[loop[i]]) / static_cast<double>(loop.size());
    drawn.loop.push_back(rounded_to(side.drawn_back[i], coordinate));
  }
  for (const Vec3& point : patch.points)
    drawn.within.push_back(rounded_to(point + mean, coordinate));
  return drawn;
}

std::vector<Triangle> triangles_of(const std::vector<Face>& faces, const DrawnSide& side) {
  std::vector<Vec3> positions = side.loop;
  positions.insert(positions.end(), side.within.begin(), side.within.end());
  std::vector<Triangle> triangles;
  for (const Face& face : faces) triangles.push_back(triangle_of(positions, face));
  return triangles;
}

/// Moves the vertices of a loop, and adds the patch vertices that are not on the loop. Returns the
/// indices of the loop vertices, followed by those of the added vertices.
std::vector<Index> add_vertices(Mesh& mesh, std::vector<Index> loop, const HolePatch& patch,
                                const DrawnSide& side) {
  std::vector<Index> all = loop;
  const BorderBlend blend(mesh, loop);
  for (std::size_t i = 0; i < patch.points.size(); ++i) {
    all.push_back(static_cast<Index>(mesh.positions.size()));
    mesh.vertex_columns.append(blend(patch.points[i]));
    mesh.positions.push_back(side.within[i]);
  }
  for (std::size_t i = 0; i < loop.size(); ++i) mesh.positions[loop[i]] = side.loop[i];
  return all;
}

}  // namespace

std::optional<HolePatch> patch_of_slit(const Mesh& mesh, const std::vector<Index>& loop,
                                       const SlitSides& sides, const HalfedgeStars& stars) {
  const std::vector<Index> faces = faces_on_left(mesh, loop, sides, stars);
  const HoleNeighborhood part = neighborhood_of(mesh, faces);
  const Index border = halfedge_in_neighborhood(faces, sides.left.corners.front().front());
  for (const Search search : {Search::delaunay, Search::all}) {
    if (search == Search::all && loop.size() > most_edges_of_all) break;
    HolePatches found = patch_hole(part.mesh, border, PatchKind::refined, search);
    for (HolePatch& patch : found.patches) {
      rename(patch, part, mesh.positions.size());
      if (!has_chord(patch, sides)) return std::move(patch);
    }
    if (found.are_of_all) break;
  }
  return std::nullopt;
}

std::vector<Triangle> ClosedSlit::left_patch() const { return triangles_of(faces, left); }

std::vector<Triangle> ClosedSlit::right_patch() const {
  std::vector<Triangle> triangles = triangles_of(faces, right);
  for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
  return triangles;
}

ClosedSlit drawn_apart(const Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                       const HolePatch& patch, Scalar coordinate) {
  ClosedSlit slit{{},
                  drawn(mesh, loop, sides.left, patch, coordinate),
                  drawn(mesh, loop, sides.right, patch, coordinate)};
  const auto vertices = static_cast<Index>(mesh.positions.size());
  for (Face face : patch.faces) {
    for (Index& v : face)
      v = static_cast<Index>(v < vertices ? std::ranges::find(loop, v) - loop.begin()
                                          : loop.size() + v - vertices);
    slit.faces.push_back(face);
  }
  return slit;
}

void close_slit(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                const HolePatch& patch, const ClosedSlit& slit) {
  const auto first_new = static_cast<Index>(mesh.positions.size());
  slit_along(mesh, loop, sides);
  std::vector<Index> copies;
  for (Index v = first_new; v < mesh.positions.size(); ++v) copies.push_back(v);
  const std::vector<Index> left = add_vertices(mesh, loop, patch, slit.left);
  const std::vector<Index> right = add_vertices(mesh, std::move(copies), patch, slit.right);
  for (const auto& [a, b, c] : slit.faces) mesh.faces.push_back({left[a], left[b], left[c]});
  // The copy of the patch on the right side has the opposite orientation.
  for (const auto& [a, b, c] : slit.faces) mesh.faces.push_back({right[a], right[c], right[b]});
}

}  // namespace transformesh
