/// Small meshes for tests, closed and oriented outwards unless their comments say otherwise.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "transformesh/mesh.h"

namespace transformesh::test {

/// Returns the tetrahedron (0,0,0), (1,0,0), (0,1,0), (0,0,1), of volume 1/6.
inline Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

/// Returns the box between two corners, with 8 vertices and 12 faces.
inline Mesh cuboid(const Vec3& low, const Vec3& high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                                i & 4 ? high.z() : low.z());
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

inline Mesh cube() { return cuboid(Vec3::Zero(), Vec3::Ones()); }

/// Returns a unit sphere: an icosahedron whose faces are split into 4^subdivisions faces each.
inline Mesh icosphere(int subdivisions) {
  const double t = std::numbers::phi;
  Mesh mesh;
  mesh.positions = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                    {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  mesh.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (Vec3& point : mesh.positions) point.normalize();

  for (; subdivisions > 0; --subdivisions) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [entry, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<Index>(mesh.positions.size()));
      const Vec3 sum = mesh.positions[a] + mesh.positions[b];
      if (is_new) mesh.positions.push_back(sum.normalized());
      return entry->second;
    };
    std::vector<Face> faces;
    for (const auto& [a, b, c] : mesh.faces) {
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      faces.insert(faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.faces = std::move(faces);
  }
  return mesh;
}

/// Returns a torus around the z axis as a grid of `around` x `across` vertices. All valences are
/// six.
inline Mesh torus(double major, double minor, int around, int across) {
  Mesh mesh;
  const auto vertex = [&](int i, int j) {
    return static_cast<Index>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around;
      const double v = 2 * std::numbers::pi * j / across;
      const double radius = major + minor * std::cos(v);
      mesh.positions.emplace_back(radius * std::cos(u), radius * std::sin(u), minor * std::sin(v));
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return mesh;
}

/// Returns the open unit square in the plane z = 0 as a grid of n x n cells, facing up.
inline Mesh grid(int n) {
  Mesh mesh;
  const auto vertex = [&](int i, int j) { return static_cast<Index>(i * (n + 1) + j); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      mesh.positions.emplace_back(i / static_cast<double>(n), j / static_cast<double>(n), 0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return mesh;
}

/// Returns a Moebius strip of n quadrilaterals around the z axis: open, with one side.
inline Mesh moebius_strip(Index n) {
  Mesh mesh;
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    for (const double s : {-0.2, 0.2}) {
      const double radius = 1 + s * std::cos(angle / 2);
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                  s * std::sin(angle / 2));
    }
  }
  for (Index i = 0; i < n; ++i) {
    const bool is_last = i + 1 == n;
    const Index a = 2 * i, b = a + 1, c = is_last ? 1 : a + 2, d = is_last ? 0 : a + 3;
    mesh.faces.push_back({a, c, b});
    mesh.faces.push_back({b, c, d});
  }
  return mesh;
}

/// Returns the faces as a soup, without columns. No two faces share a vertex.
inline Mesh soup_of(const Mesh& mesh) {
  Mesh soup;
  for (const Face& face : mesh.faces) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : face) soup.positions.push_back(mesh.positions[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// Returns a mesh with the faces of both meshes, without columns.
inline Mesh joined(const Mesh& first, const Mesh& second) {
  Mesh mesh = first;
  const Index base = static_cast<Index>(first.positions.size());
  mesh.positions.insert(mesh.positions.end(), second.positions.begin(), second.positions.end());
  for (const auto& [a, b, c] : second.faces) mesh.faces.push_back({a + base, b + base, c + base});
  return mesh;
}

inline Mesh moved(Mesh mesh, const Vec3& by) {
  for (Vec3& point : mesh.positions) point += by;
  return mesh;
}

inline Mesh scaled(Mesh mesh, double by) {
  for (Vec3& point : mesh.positions) point *= by;
  return mesh;
}

inline Mesh reversed(Mesh mesh) {
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

}  // namespace transformesh::test
