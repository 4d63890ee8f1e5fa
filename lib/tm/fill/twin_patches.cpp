#include "tm/fill/twin_patches.h"

#include <algorithm>

#include "tm/fill/mesh_part.h"
#include "tm/mesh/digits.h"

namespace transformesh {
namespace {

std::vector<Index> sorted_faces(const SlitSide& side) {
  std::vector<Index> faces;
  for (const std::vector<Index>& corners : side.corners)
    for (const Index corner : corners) faces.push_back(corner / 3);
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Within two rings of the loop, without what lies on the right of it.
std::vector<Index> faces_on_left(const Mesh& mesh, const std::vector<Index>& loop,
                                 const SlitSides& sides, const HalfedgeStars& stars) {
  std::vector<Index> faces = faces_around(mesh, loop, [&](Index v, std::vector<Index>& all) {
    stars.visit(v, [&](Index h) { all.push_back(h / 3); });
  });
  const std::vector<Index> right = sorted_faces(sides.right);
  std::erase_if(faces, [&](Index f) { return std::binary_search(right.begin(), right.end(), f); });
  return faces;
}

/// Whether an edge of the patch is there already, on either side.
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

/// In the numbers of the mesh.
void rename(HolePatch& patch, const MeshPart& part, std::size_t vertices) {
  const auto known = static_cast<Index>(part.vertices.size());
  for (Face& face : patch.faces)
    for (Index& v : face)
      v = v < known ? part.vertices[v] : static_cast<Index>(vertices) + v - known;
}

/// The vertices of a side's patch: those of the loop, and those within.
struct PatchVertices {
  std::vector<Index> loop;
  std::vector<Index> within;
};

PatchVertices add_vertices(Mesh& mesh, std::vector<Index> loop, const HolePatch& patch) {
  PatchVertices all{std::move(loop), {}};
  for (const Vec3& point : patch.points) {
    all.within.push_back(static_cast<Index>(mesh.positions.size()));
    mesh.vertex_columns.append(blend_of_nearest(mesh, all.loop, point));
    mesh.positions.push_back(point);
  }
  return all;
}

void draw(Mesh& mesh, const PatchVertices& vertices, const SlitSide& side, Scalar coordinate) {
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < vertices.loop.size(); ++i) {
    Vec3& position = mesh.positions[vertices.loop[i]];
    mean += (side.drawn_back[i] - position) / static_cast<double>(vertices.loop.size());
    position = rounded_to(side.drawn_back[i], coordinate);
  }
  for (const Index v : vertices.within)
    mesh.positions[v] = rounded_to(mesh.positions[v] + mean, coordinate);
}

}  // namespace

std::optional<HolePatch> patch_of_slit(const Mesh& mesh, const std::vector<Index>& loop,
                                       const SlitSides& sides, const HalfedgeStars& stars) {
  const std::vector<Index> faces = faces_on_left(mesh, loop, sides, stars);
  const MeshPart part = part_of(mesh, faces);
  const Index border = halfedge_in_part(faces, sides.left.corners.front().front());
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

void close_slit(Mesh& mesh, const std::vector<Index>& loop, const SlitSides& sides,
                const HolePatch& patch, Scalar coordinate) {
  const auto first_new = static_cast<Index>(mesh.positions.size());
  slit_along(mesh, loop, sides);
  std::vector<Index> copies;
  for (Index v = first_new; v < mesh.positions.size(); ++v) copies.push_back(v);
  const PatchVertices left = add_vertices(mesh, loop, patch);
  const PatchVertices right = add_vertices(mesh, std::move(copies), patch);

  // Seen from the other side a face turns the other way.
  const auto of_side = [&](const PatchVertices& side, Index v) {
    if (v >= first_new) return side.within[v - first_new];
    return side.loop[std::find(loop.begin(), loop.end(), v) - loop.begin()];
  };
  for (const auto& [a, b, c] : patch.faces)
    mesh.faces.push_back({of_side(left, a), of_side(left, b), of_side(left, c)});
  for (const auto& [a, b, c] : patch.faces)
    mesh.faces.push_back({of_side(right, a), of_side(right, c), of_side(right, b)});
  draw(mesh, left, sides.left, coordinate);
  draw(mesh, right, sides.right, coordinate);
}

}  // namespace transformesh
