#include "remesh/guards/face_tree.h"

#include "geometry/search/hilbert.h"
#include "remesh/halfedges/select_slots.h"

namespace transformesh {
// A tree with n leaves has n - 1 inner nodes, which come first.
FaceTree::FaceTree(const EditableMesh& mesh)
    : mesh_(mesh), frame_(positions_of(mesh)), leaf_of_(mesh.face_slots(), no_index) {
  std::vector<FloatBox> boxes;
  std::vector<Index> faces;
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    if (!mesh.has_face(face)) continue;
    faces.push_back(face);
    boxes.push_back(box_of(face));
  }
  if (faces.empty()) return;
  boxes_.resize(2 * faces.size() - 1);
  for (const Index place : hilbert_order(boxes)) {
    const std::size_t leaf = faces.size() - 1 + face_of_.size();
    leaf_of_[faces[place]] = static_cast<Index>(leaf);
    face_of_.push_back(faces[place]);
    boxes_[leaf] = boxes[place];
  }
  for (std::size_t node = faces.size() - 1; node-- > 0;)
    boxes_[node] = boxes_[2 * node + 1].merged(boxes_[2 * node + 2]);
}

FloatBox FaceTree::box_of(Index face) const {
  const auto [a, b, c] = mesh_.triangle(face);
  return frame_.box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
}

void FaceTree::update(Index face) {
  std::size_t node = leaf_of_[face];
  FloatBox box = mesh_.has_face(face) ? box_of(face) : FloatBox();
  while (box.min() != boxes_[node].min() || box.max() != boxes_[node].max()) {
    boxes_[node] = box;
    if (node == 0) return;
    node = (node - 1) / 2;
    box = boxes_[2 * node + 1].merged(boxes_[2 * node + 2]);
  }
}

}  // namespace transformesh
