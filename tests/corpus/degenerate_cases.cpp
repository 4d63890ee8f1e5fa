// Faces without area, edges without length, repeated and unused vertices, soups.
#include <map>

#include "corpus/build.h"
#include "corpus/cases.h"

namespace transformesh::corpus {
namespace {

/// Splits a face at its edge from corner i, at the fraction `share` of the edge, and fills the gap
/// to the neighbor with a face without area. At 0 and 1 the new edge has no length.
void insert_flat_face(Mesh& mesh, Index face, int i, double share) {
  const Index a = mesh.faces[face][i];
  const Index b = mesh.faces[face][(i + 1) % 3];
  const Index c = mesh.faces[face][(i + 2) % 3];
  const Index middle = static_cast<Index>(mesh.positions.size());
  const Vec3 from = mesh.positions[a];
  mesh.positions.push_back(share == 1 ? mesh.positions[b]
                                      : from + share * (mesh.positions[b] - from));
  mesh.faces[face] = {a, middle, c};
  mesh.faces.push_back({middle, b, c});
  mesh.faces.push_back({a, b, middle});
}

/// The fraction is one half, so that the new vertex lies exactly on the edge, or 0 or 1.
Mesh with_flat_faces(Mesh mesh, int count, bool has_length, std::uint64_t seed) {
  Random random(seed);
  while (count-- > 0) {
    const Index face = static_cast<Index>(random.below(mesh.faces.size()));
    const double share = has_length ? 0.5 : static_cast<double>(random.below(2));
    insert_flat_face(mesh, face, static_cast<int>(random.below(3)), share);
  }
  return mesh;
}

/// Faces that use a vertex twice or three times.
Mesh with_collapsed_faces(Mesh mesh, int count, std::uint64_t seed) {
  Random random(seed);
  while (count-- > 0) {
    const Face face = mesh.faces[random.below(mesh.faces.size())];
    mesh.faces.push_back({face[0], face[1], face[random.below(2)]});
  }
  return mesh;
}

Mesh with_unused_vertices(Mesh mesh, int count, std::uint64_t seed) {
  Random random(seed);
  while (count-- > 0) mesh.positions.push_back(random.point(-2, 2));
  return mesh;
}

/// A third of the corners get vertices of their own.
Mesh partly_unshared(const Mesh& mesh, std::uint64_t seed) {
  Random random(seed);
  Mesh result = mesh;
  for (Face& face : result.faces)
    for (Index& v : face) {
      if (random.below(3) != 0) continue;
      result.positions.push_back(result.positions[v]);
      v = static_cast<Index>(result.positions.size() - 1);
    }
  return result;
}

/// Merges vertices at equal positions, so that touching parts share edges and vertices by index.
Mesh welded(const Mesh& mesh) {
  std::map<std::array<double, 3>, Index> vertices;
  Mesh result;
  for (const Face& face : mesh.faces) {
    result.faces.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const Vec3& p = mesh.positions[face[i]];
      const auto [entry, is_new] =
          vertices.try_emplace({p.x(), p.y(), p.z()}, static_cast<Index>(result.positions.size()));
      if (is_new) result.positions.push_back(p);
      result.faces.back()[i] = entry->second;
    }
  }
  return result;
}

}  // namespace

void add_degenerate_cases(Cases& cases) {
  const std::vector<std::pair<std::string, Mesh>> shapes = {
      {"ball", icosphere(1)},
      {"crossing-balls", joined(icosphere(2), moved(icosphere(2), {0.75, 0.25, 0.125}))},
      {"crossing-cubes", joined(cube(), moved(cube(), {0.5, 0.5, 0.5}))},
      {"flush-cubes", joined(cube(), moved(cube(), {0.5, 0.25, 0}))},
      {"stacked-cubes", joined(cube(), moved(cube(), {1, 0, 0}))},
  };
  for (const auto& [shape, mesh] : shapes) {
    for (const int count : {1, 5, 30}) {
      const std::string name = shape + "/" + std::to_string(count);
      const std::uint64_t seed = static_cast<std::uint64_t>(count);
      cases.push_back({"zero-area", name,
                       [=, mesh = mesh] { return with_flat_faces(mesh, count, true, seed); }});
      cases.push_back({"zero-length", name,
                       [=, mesh = mesh] { return with_flat_faces(mesh, count, false, seed); }});
      cases.push_back({"zero-length", "collapsed-faces/" + name,
                       [=, mesh = mesh] { return with_collapsed_faces(mesh, count, seed); }});
      cases.push_back({"zero-length", "both/" + name, [=, mesh = mesh] {
                         const Mesh flat = with_flat_faces(mesh, count, true, seed);
                         return with_collapsed_faces(with_flat_faces(flat, count, false, seed + 1),
                                                     count, seed);
                       }});
    }
    cases.push_back(
        {"duplicate-vertices", "soup/" + shape, [mesh = mesh] { return soup_of(mesh); }});
    cases.push_back({"duplicate-vertices", "partly/" + shape,
                     [mesh = mesh] { return partly_unshared(mesh, 9); }});
    cases.push_back(
        {"duplicate-vertices", "welded/" + shape, [mesh = mesh] { return welded(mesh); }});
    cases.push_back({"duplicate-vertices", "unused/" + shape,
                     [mesh = mesh] { return with_unused_vertices(mesh, 7, 3); }});
  }
  for (const auto& [name, shift] : std::vector<std::pair<std::string, Vec3>>{
           {"vertex", {1, 1, 1}}, {"edge", {1, 1, 0}}, {"face", {1, 0, 0}}})
    cases.push_back({"touching", "sharing-a-" + name,
                     [shift = shift] { return welded(joined(cube(), moved(cube(), shift))); }});
}

}  // namespace transformesh::corpus
