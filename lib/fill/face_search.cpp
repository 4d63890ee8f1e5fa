#include "fill/face_search.h"

#include <algorithm>

#include "fill/hole_neighborhood.h"
#include "transformesh/intersect.h"

namespace transformesh {

FaceSearch::FaceSearch(const Mesh& mesh) : mesh_(mesh), frame_(mesh.positions) { update(); }

void FaceSearch::update() {
  Index first = trees_.empty() ? 0 : trees_.back().first + trees_.back().count;
  const auto last = static_cast<Index>(mesh_.faces.size());
  if (first == last) return;
  for (; !trees_.empty() && trees_.back().count < 2 * (last - first); trees_.pop_back())
    first = trees_.back().first;
  std::vector<FloatBox> boxes;
  boxes.reserve(last - first);
  for (Index f = first; f < last; ++f) boxes.push_back(box(triangle_of(mesh_, f)));
  trees_.push_back({first, last - first, Bvh(boxes)});
}

std::vector<Index> FaceSearch::near(std::span<const Triangle> triangles) const {
  std::vector<FloatBox> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) boxes.push_back(box(triangle));
  const Bvh around(boxes);
  std::vector<Index> faces;
  for (const Tree& tree : trees_)
    tree.bvh.visit_overlaps(around, [&](Index i) { faces.push_back(tree.first + i); });
  std::sort(faces.begin(), faces.end());
  return faces;
}

FloatBox FaceSearch::box(const Triangle& triangle) const {
  const auto& [a, b, c] = triangle;
  return frame_.box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
}

bool FaceSearch::intersect(std::span<const Triangle> triangles) const {
  Mesh both = neighborhood_of(mesh_, near(triangles)).mesh;
  const std::size_t old_faces = both.faces.size();
  // Each corner is a separate vertex, because the intersection test treats equal positions as one
  // point.
  for (const Triangle& triangle : triangles) {
    const auto first = static_cast<Index>(both.positions.size());
    both.positions.insert(both.positions.end(), triangle.begin(), triangle.end());
    both.faces.push_back({first, first + 1, first + 2});
  }
  const std::vector<FacePair> pairs = find_intersections(both);
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const FacePair& pair) { return pair.second >= old_faces; });
}

}  // namespace transformesh
