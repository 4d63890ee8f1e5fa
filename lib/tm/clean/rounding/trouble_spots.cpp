#include "tm/clean/rounding/trouble_spots.h"

#include <algorithm>

#include "tm/clean/intersect/welded_mesh.h"

namespace transformesh {

TroubleSpots::TroubleSpots(const Mesh& mesh)
    : frame_(weld(mesh).frame), failures_of_input_(mesh.faces.size(), 0) {}

FloatBox TroubleSpots::box(const Mesh& mesh, Index face) const {
  const auto& [a, b, c] = mesh.faces[face];
  const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
  return frame_.box(p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r));
}

int TroubleSpots::failures_at(const Mesh& mesh, Index face) const {
  int failures = 0;
  bvh_.visit_overlaps(box(mesh, face), [&](Index i) {
    failures = std::max(failures, failures_[i]);
    return failures < most_failures_;
  });
  return failures;
}

void TroubleSpots::add(const Assembly& assembly, const std::vector<Index>& faces) {
  std::vector<int> failures;
  failures.reserve(faces.size());
  for (const Index face : faces) failures.push_back(failures_at(assembly.mesh, face) + 1);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    boxes_.push_back(box(assembly.mesh, faces[i]));
    failures_.push_back(failures[i]);
    int& of_input = failures_of_input_[assembly.source_face[faces[i]]];
    of_input = std::max(of_input, failures[i]);
    most_failures_ = std::max(most_failures_, failures[i]);
  }
  bvh_ = Bvh(boxes_);
}

}  // namespace transformesh
