#include "fill/face_search.h"

#include "mesh/triangle.h"

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
  for (Index f = first; f < last; ++f) {
    const auto [a, b, c] = triangle_of(mesh_.positions, mesh_.faces[f]);
    boxes.push_back(frame_.box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)));
  }
  trees_.push_back({first, last - first, Bvh(boxes)});
}

void FaceSearch::append_near(const Vec3& low, const Vec3& high, std::vector<Index>& faces) const {
  const FloatBox box = frame_.box(low, high);
  for (const Tree& tree : trees_)
    tree.bvh.visit_overlaps(box, [&](Index i) {
      faces.push_back(tree.first + i);
      return true;
    });
}

}  // namespace transformesh
