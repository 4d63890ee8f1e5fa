#include "corpus/repair/damage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "helpers/random.h"
#include "helpers/shapes.h"

namespace transformesh::corpus {
namespace {

using test::Random;

double diagonal(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.positions) box.extend(point);
  return box.diagonal().norm();
}

Vec3 extent(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.positions) box.extend(point);
  return box.sizes();
}

Vec3 middle(const Mesh& mesh, const Face& face) {
  return (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3;
}

Vec3 normal(const Mesh& mesh, const Face& face) {
  const Vec3& a = mesh.positions[face[0]];
  return (mesh.positions[face[1]] - a).cross(mesh.positions[face[2]] - a).normalized();
}

std::size_t any_face(const Mesh& mesh, Random& random) { return random.below(mesh.faces.size()); }

Face reverse(const Face& face) { return {face[0], face[2], face[1]}; }

Mesh without(const Mesh& mesh, const std::vector<char>& is_gone) {
  Mesh rest{mesh.positions, {}, {}, {}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (!is_gone[f]) rest.faces.push_back(mesh.faces[f]);
  return rest;
}

// --- Connections ---------------------------------------------------------------------------------

Mesh soup(const Mesh& solid, std::uint64_t) { return test::soup_of(solid); }

Mesh shuffled_soup(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  for (std::size_t f = mesh.faces.size(); f > 1; --f)
    std::swap(mesh.faces[f - 1], mesh.faces[random.below(f)]);
  for (Face& face : mesh.faces)
    std::rotate(face.begin(), face.begin() + static_cast<long>(random.below(3)), face.end());
  return test::soup_of(mesh);
}

/// Moves every corner of the soup by up to half of this fraction of the diagonal in each direction.
Mesh cracked(const Mesh& solid, std::uint64_t seed, double share) {
  Random random(seed);
  Mesh mesh = test::soup_of(solid);
  const double width = share * diagonal(solid);
  for (Vec3& point : mesh.positions) point += random.point(-width / 2, width / 2);
  return mesh;
}
Mesh hair_cracks(const Mesh& solid, std::uint64_t seed) { return cracked(solid, seed, 1e-9); }
Mesh cracks(const Mesh& solid, std::uint64_t seed) { return cracked(solid, seed, 1e-6); }
Mesh wide_cracks(const Mesh& solid, std::uint64_t seed) { return cracked(solid, seed, 2e-5); }

Mesh seams(const Mesh& solid, std::uint64_t seed) {
  // Faces on both sides of a plane get vertices of their own, which differ slightly in position.
  Random random(seed);
  Mesh mesh = solid;
  const Vec3 direction = random.point(-1, 1).normalized();
  const double width = 1e-6 * diagonal(solid);
  std::map<Index, Index> copies;
  for (Face& face : mesh.faces) {
    if (direction.dot(middle(solid, face)) < 0) continue;
    for (Index& v : face) {
      const auto [copy, is_new] = copies.try_emplace(v, static_cast<Index>(mesh.positions.size()));
      if (is_new) {
        const Vec3 place = mesh.positions[v] + random.point(-width, width);
        mesh.positions.push_back(place);
      }
      v = copy->second;
    }
  }
  return mesh;
}

/// Splits some edges on only one of their sides.
Mesh t_junctions(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  const std::size_t count = mesh.faces.size();
  for (std::size_t f = 0; f < count; ++f) {
    if (random.below(5) != 0) continue;
    const Face face = mesh.faces[f];
    const auto added = static_cast<Index>(mesh.positions.size());
    const Vec3 place = (mesh.positions[face[0]] + mesh.positions[face[1]]) / 2;
    mesh.positions.push_back(place);
    mesh.faces[f] = {face[0], added, face[2]};
    mesh.faces.push_back({added, face[1], face[2]});
  }
  return mesh;
}

Mesh few_digits(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  const Eigen::AngleAxisd turn(random.uniform(0, 3), random.point(-1, 1).normalized());
  Mesh mesh = test::soup_of(solid);
  for (Vec3& point : mesh.positions)
    for (double& x : point = turn * point) x = std::round(x * 1e5) / 1e5;
  return mesh;
}

// --- Orientation ---------------------------------------------------------------------------------

Mesh reversed_faces(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  for (Face& face : mesh.faces)
    if (random.below(4) == 0) face = reverse(face);
  return mesh;
}

Mesh reversed_soup(const Mesh& solid, std::uint64_t seed) {
  return test::soup_of(reversed_faces(solid, seed));
}

Mesh inside_out(const Mesh& solid, std::uint64_t) { return test::reversed(solid); }

Mesh one_inside_out(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  const Vec3 by = 1.5 * diagonal(solid) * random.point(-1, 1).normalized();
  return test::joined(solid, test::reversed(test::moved(solid, by)));
}

// --- Missing and additional faces ----------------------------------------------------------------

Mesh missing_face(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  std::vector<char> is_gone(solid.faces.size(), 0);
  is_gone[any_face(solid, random)] = 1;
  return without(solid, is_gone);
}

Mesh missing_faces(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  std::vector<char> is_gone(solid.faces.size(), 0);
  for (char& gone : is_gone) gone = random.below(50) == 0;
  return without(solid, is_gone);
}

/// Removes the faces at a vertex. If a solid has few faces, removes only the two at an edge,
/// because all faces at a vertex would be half of the solid.
Mesh missing_patch(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  const Face at = solid.faces[any_face(solid, random)];
  const bool has_few = solid.faces.size() < 100;
  std::vector<char> is_gone(solid.faces.size(), 0);
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const auto has = [&](Index v) { return std::ranges::count(solid.faces[f], v) > 0; };
    is_gone[f] = has(at[0]) && (!has_few || has(at[1]));
  }
  return without(solid, is_gone);
}

Mesh duplicate_faces(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  for (const Face& face : solid.faces)
    if (random.below(10) == 0) mesh.faces.push_back(face);
  return mesh;
}

Mesh duplicate_shell(const Mesh& solid, std::uint64_t) { return test::joined(solid, solid); }

Mesh duplicate_soup(const Mesh& solid, std::uint64_t seed) {
  return test::soup_of(test::joined(solid, reversed_faces(solid, seed)));
}

Mesh double_sided(const Mesh& solid, std::uint64_t) {
  return test::joined(solid, test::reversed(solid));
}

Mesh double_sided_soup(const Mesh& solid, std::uint64_t seed) {
  Mesh mesh = solid;
  for (const Face& face : solid.faces) mesh.faces.push_back(reverse(face));
  return shuffled_soup(mesh, seed);
}

Mesh fin(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  const Face face = mesh.faces[any_face(solid, random)];
  const Vec3 tip = middle(mesh, face) + 0.1 * diagonal(mesh) * normal(mesh, face);
  mesh.positions.push_back(tip);
  mesh.faces.push_back({face[0], face[1], static_cast<Index>(mesh.positions.size() - 1)});
  return mesh;
}

Mesh inner_face(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  const Face face = mesh.faces[any_face(solid, random)];
  const Vec3 tip = middle(mesh, face) - 0.02 * diagonal(mesh) * normal(mesh, face);
  mesh.positions.push_back(tip);
  mesh.faces.push_back({face[0], face[1], static_cast<Index>(mesh.positions.size() - 1)});
  return mesh;
}

Mesh inner_shell(const Mesh& solid, std::uint64_t seed) {
  // Adds a small ball just inside a face, oriented outwards; the solid already contains it.
  Random random(seed);
  const Face face = solid.faces[any_face(solid, random)];
  const double radius = 0.005 * diagonal(solid);
  const Vec3 at = middle(solid, face) - 3 * radius * normal(solid, face);
  return test::joined(solid, test::moved(test::scaled(test::icosphere(1), radius), at));
}

Mesh shard(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  const Vec3 at = diagonal(solid) * random.point(-1, 1).normalized();
  return test::joined(solid,
                      test::moved(test::scaled(test::tetrahedron(), 1e-4 * diagonal(solid)), at));
}

Mesh loose_triangle(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  const Vec3 at = diagonal(solid) * random.point(-1, 1).normalized();
  const auto first = static_cast<Index>(mesh.positions.size());
  for (int i = 0; i < 3; ++i) {
    const Vec3 corner = at + 0.01 * diagonal(solid) * random.point(-1, 1);
    mesh.positions.push_back(corner);
  }
  mesh.faces.push_back({first, first + 1, first + 2});
  return mesh;
}

// --- Degenerate faces ----------------------------------------------------------------------------

Mesh collapsed_faces(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  for (int i = 0; i < 5; ++i) {
    const Face face = mesh.faces[any_face(solid, random)];
    mesh.faces.push_back({face[0], face[1], face[1]});
  }
  return mesh;
}

Mesh flat_faces(const Mesh& solid, std::uint64_t seed) {
  // Splits an edge on one side, and covers the difference by a face without area.
  Random random(seed);
  Mesh mesh = solid;
  for (int i = 0; i < 5; ++i) {
    const std::size_t f = any_face(solid, random);
    const Face face = mesh.faces[f];
    const auto added = static_cast<Index>(mesh.positions.size());
    const Vec3 place = (mesh.positions[face[0]] + mesh.positions[face[1]]) / 2;
    mesh.positions.push_back(place);
    mesh.faces[f] = {face[0], added, face[2]};
    mesh.faces.push_back({added, face[1], face[2]});
    mesh.faces.push_back({face[0], face[1], added});
  }
  return mesh;
}

Mesh zero_edges(const Mesh& solid, std::uint64_t seed) {
  // Moves some faces of a vertex to a copy of it, and connects both by two faces without area.
  Random random(seed);
  Mesh mesh = solid;
  const Face face = mesh.faces[any_face(solid, random)];
  const auto copy = static_cast<Index>(mesh.positions.size());
  const Vec3 place = mesh.positions[face[0]];
  mesh.positions.push_back(place);
  for (Face& other : mesh.faces)
    if (other == face) other[0] = copy;
  mesh.faces.push_back({face[0], face[1], copy});
  mesh.faces.push_back({copy, face[2], face[0]});
  return mesh;
}

// --- Self-intersections --------------------------------------------------------------------------

Mesh overlap(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  const Vec3 by = 0.3 * diagonal(solid) * random.point(-1, 1).normalized();
  return test::joined(solid, test::moved(solid, by));
}

Mesh touching_bodies(const Mesh& solid, std::uint64_t) {
  return test::joined(solid, test::moved(solid, {extent(solid).x(), 0, 0}));
}

Mesh bow_tie(const Mesh& solid, std::uint64_t) {
  // The solid and its point reflection in the vertex farthest along x, which both share.
  Index tip = 0;
  for (Index v = 0; v < solid.positions.size(); ++v)
    if (solid.positions[v].x() > solid.positions[tip].x()) tip = v;
  Mesh image = test::reversed(solid);
  for (Vec3& point : image.positions) point = 2 * solid.positions[tip] - point;
  Mesh both = test::joined(solid, image);
  const auto copy = static_cast<Index>(solid.positions.size()) + tip;
  for (Face& face : both.faces)
    for (Index& v : face) v = v == copy ? tip : v;
  return both;
}

Mesh folded_vertex(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  const Face face = mesh.faces[any_face(solid, random)];
  const Vec3 along = mesh.positions[face[1]] - mesh.positions[face[0]];
  mesh.positions[face[0]] += 1.7 * along;
  return mesh;
}

Mesh spikes(const Mesh& solid, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = solid;
  for (int i = 0; i < 3; ++i) {
    const Face face = mesh.faces[any_face(solid, random)];
    mesh.positions[face[0]] += 0.2 * diagonal(solid) * normal(solid, face);
  }
  return mesh;
}

Mesh everything(const Mesh& solid, std::uint64_t seed) {
  return cracks(duplicate_faces(reversed_faces(missing_face(shard(solid, seed), seed), seed), seed),
                seed);
}

}  // namespace

const std::vector<Damage>& damages() {
  static const std::vector<Damage> all{{"soup", soup},
                                       {"shuffled-soup", shuffled_soup},
                                       {"hair-cracks", hair_cracks},
                                       {"cracks", cracks},
                                       {"wide-cracks", wide_cracks},
                                       {"seams", seams},
                                       {"t-junctions", t_junctions},
                                       {"few-digits", few_digits},
                                       {"reversed-faces", reversed_faces},
                                       {"reversed-soup", reversed_soup},
                                       {"inside-out", inside_out},
                                       {"one-inside-out", one_inside_out, 2},
                                       {"missing-face", missing_face},
                                       {"missing-faces", missing_faces},
                                       {"missing-patch", missing_patch},
                                       {"duplicate-faces", duplicate_faces},
                                       {"duplicate-shell", duplicate_shell},
                                       {"duplicate-soup", duplicate_soup},
                                       {"double-sided", double_sided},
                                       {"double-sided-soup", double_sided_soup},
                                       {"fin", fin},
                                       {"inner-face", inner_face},
                                       {"inner-shell", inner_shell},
                                       {"shard", shard},
                                       {"loose-triangle", loose_triangle},
                                       {"collapsed-faces", collapsed_faces},
                                       {"flat-faces", flat_faces},
                                       {"zero-edges", zero_edges},
                                       {"overlap", overlap, 0},
                                       {"touching-bodies", touching_bodies, 2},
                                       {"bow-tie", bow_tie, 2},
                                       {"folded-vertex", folded_vertex, 0},
                                       {"spikes", spikes, 0},
                                       {"everything", everything}};
  return all;
}

}  // namespace transformesh::corpus
