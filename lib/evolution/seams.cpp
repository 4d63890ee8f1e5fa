#include "evolution/seams.h"

#include <algorithm>
#include <functional>
#include <map>

#include "mesh/disjoint_sets.h"

namespace transformesh {
namespace {

bool is_less(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

std::vector<char> find_new_vertices(const Mesh& before, const Mesh& cleaned) {
  std::vector<Vec3> known = before.positions;
  std::ranges::sort(known, is_less);
  std::vector<char> is_new;
  for (const Vec3& point : cleaned.positions)
    is_new.push_back(std::ranges::binary_search(known, point, is_less) ? 0 : 1);
  return is_new;
}

/// Marks vertices at which faces with different component labels meet. If surfaces touch exactly at
/// vertices, cleaning joins them there without creating vertices that find_new_vertices() could
/// find.
void mark_where_labels_meet(const Mesh& mesh, const std::vector<long>& labels,
                            std::vector<char>& is_marked) {
  std::vector<long> first(mesh.positions.size(), 0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (const Index v : mesh.faces[f]) {
      if (first[v] == 0) first[v] = labels[f];
      if (first[v] != labels[f]) is_marked[v] = 1;
    }
}

/// Returns the sets of marked vertices that are connected by edges.
DisjointSets connected(const Mesh& mesh, const std::vector<char>& is_marked) {
  DisjointSets sets(mesh.positions.size());
  for (const Face& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = face[i], b = face[(i + 1) % 3];
      if (is_marked[a] && is_marked[b]) sets.join(a, b);
    }
  return sets;
}

}  // namespace

std::vector<Seam> find_seams(const Mesh& before, const Mesh& cleaned,
                             const Components& components) {
  const std::vector<long> labels = face_labels(cleaned);
  std::vector<char> is_marked = find_new_vertices(before, cleaned);
  mark_where_labels_meet(cleaned, labels, is_marked);
  DisjointSets sets = connected(cleaned, is_marked);
  std::map<Index, Seam> seams;
  for (std::size_t f = 0; f < cleaned.faces.size(); ++f)
    for (const Index v : cleaned.faces[f]) {
      if (!is_marked[v]) continue;
      Seam& seam = seams[sets.find(v)];
      seam.labels.insert(labels[f]);
      seam.components.insert(components.of_face[f]);
    }
  std::map<Index, std::vector<Vec3>> points;
  for (Index v = 0; v < is_marked.size(); ++v)
    if (is_marked[v]) points[sets.find(v)].push_back(cleaned.positions[v]);
  std::vector<Seam> result;
  for (auto& [root, seam] : seams) {
    seam.extent = extent_of(points[root]);
    result.push_back(std::move(seam));
  }
  std::ranges::stable_sort(result, std::greater(),
                           [](const Seam& seam) { return seam.extent.size; });
  return result;
}

}  // namespace transformesh
