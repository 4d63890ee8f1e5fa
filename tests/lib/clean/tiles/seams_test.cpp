/// Meshes that are cut into parts and joined again, compared with the original.
#include "clean/tiles/seams.h"

#include <doctest/doctest.h>

#include <map>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

struct Parts {
  std::vector<Mesh> meshes;
  // For each part, the numbers of its faces in the whole mesh.
  std::vector<std::vector<Index>> faces;
};

/// Cuts the mesh into parts, each with its own vertices.
Parts cut(const Mesh& mesh, const std::vector<int>& part_of, int count) {
  Parts parts;
  for (int p = 0; p < count; ++p) {
    Mesh part;
    std::map<Index, Index> number_of;
    parts.faces.emplace_back();
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      if (part_of[f] != p) continue;
      parts.faces.back().push_back(f);
      Face face;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index v = mesh.faces[f][i];
        const auto [place, is_new] =
            number_of.emplace(v, static_cast<Index>(part.positions.size()));
        if (is_new) part.positions.push_back(mesh.positions[v]);
        face[i] = place->second;
      }
      part.faces.push_back(face);
    }
    parts.meshes.push_back(part);
  }
  return parts;
}

/// Joins the parts, with faces in the order of the whole mesh.
Mesh joined(const Mesh& mesh, const Parts& parts, std::size_t& left) {
  Seams seams;
  for (const Mesh& part : parts.meshes)
    seams.add(part.faces, part.positions.size(), [&](Index v) { return part.positions[v]; });
  left = seams.join();
  Mesh result;
  result.positions.assign(seams.vertex_count(), Vec3::Constant(-99));
  result.faces.resize(mesh.faces.size());
  for (std::size_t p = 0; p < parts.meshes.size(); ++p) {
    const std::vector<Index> number = seams.numbers_of(p);
    const std::vector<bool> repeated = seams.is_repeated(p);
    for (Index v = 0; v < number.size(); ++v) {
      Vec3& position = result.positions.at(number[v]);
      CHECK(position == (repeated[v] ? parts.meshes[p].positions[v] : Vec3::Constant(-99)));
      position = parts.meshes[p].positions[v];
    }
    for (std::size_t f = 0; f < parts.faces[p].size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        result.faces[parts.faces[p][f]][i] = number[parts.meshes[p].faces[f][i]];
  }
  return result;
}

/// Returns true if the vertices of both meshes correspond one to one.
bool are_same(const Mesh& a, const Mesh& b) {
  std::map<Index, Index> to, from;
  for (std::size_t f = 0; f < a.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = a.faces[f][i], w = b.faces[f][i];
      if (to.emplace(v, w).first->second != w || from.emplace(w, v).first->second != v)
        return false;
      if (a.positions[v] != b.positions[w]) return false;
    }
  return true;
}

std::vector<int> random_parts(std::size_t faces, int count, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<int> part_of(faces);
  for (int& part : part_of) part = static_cast<int>(random.below(count));
  return part_of;
}

}  // namespace

TEST_CASE("parts are joined to the mesh that they were cut from, wherever the seams are") {
  const Mesh mesh =
      test::joined(test::torus(2, .7, 14, 9), test::moved(test::icosphere(2), {9, 0, 0}));
  for (const int count : {1, 2, 5}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      std::size_t left = 1;
      const Parts parts = cut(mesh, random_parts(mesh.faces.size(), count, seed), count);
      const Mesh result = joined(mesh, parts, left);
      CHECK(left == 0);
      CHECK(are_same(mesh, result));
    }
  }
}

TEST_CASE("copies of vertices where cubes touch in a corner, or along an edge, stay apart") {
  const Mesh cube = test::cube();
  for (const Vec3& by : {Vec3(1, 1, 1), Vec3(1, 1, 0)}) {
    const Mesh mesh = test::joined(cube, test::moved(cube, by));
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      std::size_t left = 1;
      const Parts parts = cut(mesh, random_parts(mesh.faces.size(), 3, seed), 3);
      const Mesh result = joined(mesh, parts, left);
      CHECK(left == 0);
      CHECK(are_same(mesh, result));
      CHECK(result.positions.size() == 16);
    }
  }
}

TEST_CASE("edges without a partner are counted, and edges of three faces refused") {
  Mesh mesh = test::cube();
  mesh.faces.pop_back();
  std::size_t left = 0;
  const Parts parts = cut(mesh, random_parts(mesh.faces.size(), 2, 1), 2);
  joined(mesh, parts, left);
  CHECK(left == 3);
  mesh = test::cube();
  mesh.faces.push_back(mesh.faces[0]);
  Seams seams;
  CHECK_THROWS_AS(seams.add(mesh.faces, 8, [&](Index v) { return mesh.positions[v]; }), InputError);
}
