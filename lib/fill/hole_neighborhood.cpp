#include "fill/hole_neighborhood.h"

#include <algorithm>
#include <numeric>

#include "mesh/disjoint_sets.h"
#include "mesh/umbrellas.h"

namespace transformesh {

HoleNeighborhood neighborhood_of(const Mesh& mesh, const std::vector<Index>& faces) {
  HoleNeighborhood part;
  for (const Index f : faces)
    part.vertices.insert(part.vertices.end(), mesh.faces[f].begin(), mesh.faces[f].end());
  std::sort(part.vertices.begin(), part.vertices.end());
  part.vertices.erase(std::unique(part.vertices.begin(), part.vertices.end()), part.vertices.end());
  for (const Index v : part.vertices) part.mesh.positions.push_back(mesh.positions[v]);
  const auto local = [&](Index v) {
    const auto found = std::lower_bound(part.vertices.begin(), part.vertices.end(), v);
    return static_cast<Index>(found - part.vertices.begin());
  };
  for (const Index f : faces) {
    const Face& face = mesh.faces[f];
    part.mesh.faces.push_back({local(face[0]), local(face[1]), local(face[2])});
  }
  return part;
}

Index halfedge_in_neighborhood(const std::vector<Index>& faces, Index halfedge) {
  const auto place = std::lower_bound(faces.begin(), faces.end(), halfedge / 3);
  return static_cast<Index>(3 * (place - faces.begin())) + halfedge % 3;
}

HoleNeighborhood with_other_holes_apart(const Mesh& mesh, const std::vector<Index>& loop) {
  HoleNeighborhood apart{mesh, {}};
  const Umbrellas umbrellas = find_umbrellas(mesh, Edges(mesh));
  if (umbrellas.vertex_of.size() == mesh.positions.size()) {
    apart.vertices.resize(mesh.positions.size());
    std::iota(apart.vertices.begin(), apart.vertices.end(), Index{0});
    return apart;
  }
  DisjointSets sets(umbrellas.vertex_of.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
    sets.join(umbrellas.of_corner[next_halfedge(loop[i])],
              umbrellas.of_corner[loop[(i + 1) % loop.size()]]);
  apart.mesh.positions.clear();
  std::vector<Index> number(umbrellas.vertex_of.size());
  for (Index u = 0; u < number.size(); ++u) {
    number[u] =
        sets.find(u) == u ? static_cast<Index>(apart.vertices.size()) : number[sets.find(u)];
    if (sets.find(u) != u) continue;
    apart.vertices.push_back(umbrellas.vertex_of[u]);
    apart.mesh.positions.push_back(mesh.positions[umbrellas.vertex_of[u]]);
  }
  for (Index h = 0; h < umbrellas.of_corner.size(); ++h)
    apart.mesh.faces[h / 3][h % 3] = number[umbrellas.of_corner[h]];
  return apart;
}

std::vector<Index> faces_around(const Mesh& mesh, std::vector<Index> vertices,
                                const FacesOfVertex& append_faces) {
  std::vector<Index> faces;
  for (int ring = 0; ring < 2; ++ring) {
    for (const Index v : vertices) append_faces(v, faces);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    vertices.clear();
    for (const Index f : faces)
      vertices.insert(vertices.end(), mesh.faces[f].begin(), mesh.faces[f].end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return faces;
}

namespace {

std::vector<Index> sorted(std::vector<Index> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::vector<Vec3> positions_of(const Mesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Vec3> positions;
  positions.reserve(vertices.size());
  for (const Index v : vertices) positions.push_back(mesh.positions[v]);
  return positions;
}

}  // namespace

BorderBlend::BorderBlend(const Mesh& mesh, std::vector<Index> vertices)
    : mesh_(mesh), vertices_(sorted(std::move(vertices))), tree_(positions_of(mesh, vertices_)) {}

RowBlend BorderBlend::operator()(const Vec3& point) const {
  std::vector<std::pair<double, Index>> distances;
  const auto add = [&](Index i) {
    distances.emplace_back((mesh_.positions[vertices_[i]] - point).norm(), i);
    return false;
  };
  for (const Index i : tree_.nearest(point, 3)) add(i);
  // Vertices at almost the third distance follow, because the tree compares squared distances,
  // which are rounded differently.
  tree_.nearest_within(point, distances.back().first * (1 + 1e-12), add);
  std::sort(distances.begin(), distances.end());
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  RowBlend blend;
  if (distances[0].first == 0) {
    blend.source[0] = vertices_[distances[0].second];
    return blend;
  }
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    blend.source.at(i) = vertices_[distances[i].second];
    blend.weight.at(i) = distances[0].first / distances[i].first;
    sum += blend.weight.at(i);
  }
  for (double& weight : blend.weight) weight /= sum;
  return blend;
}

}  // namespace transformesh
