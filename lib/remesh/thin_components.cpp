#include "remesh/thin_components.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "remesh/halfedges/select_slots.h"

namespace transformesh {
namespace {

/// Traverses components until their area reaches a limit.
class AreaWalk {
 public:
  AreaWalk(const EditableMesh& mesh, double edge)
      : mesh_(mesh),
        shortest_(edge * edge),
        most_area_(std::numbers::pi * edge * edge),
        reached_(mesh.face_slots(), 0) {}

  bool has_short_edge(Index face) const {
    const auto [a, b, c] = mesh_.scaled_squared_lengths(face);
    return std::min({a, b, c}) < shortest_;
  }

  /// Returns whether the component of `seed` is closed and has less area than the limit. False if
  /// an earlier walk reached `seed` or another face of the component.
  bool walk(Index seed) {
    if (reached_[seed] != 0) return false;
    faces_.assign(1, seed);
    reached_[seed] = ++walk_;
    area_ = six_volumes_ = scaled_area_ = 0;
    const Vec3& origin = mesh_.position(mesh_.source(3 * seed));
    for (std::size_t i = 0; i < faces_.size(); ++i)  // NOLINT: reach_neighbors() adds to them
      if (!measure(faces_[i], origin) || !reach_neighbors(faces_[i])) return false;
    return true;
  }

  const std::vector<Index>& faces() const { return faces_; }
  double area() const { return area_; }
  double volume() const { return std::abs(six_volumes_ / 6); }

 private:
  bool measure(Index face, const Vec3& origin) {
    const Vec3 normal = mesh_.face_normal(face);
    const double area = 0.5 * normal.norm();
    double sizes = 0;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) sizes += mesh_.size(mesh_.source(h));
    area_ += area;
    scaled_area_ += 9 * area / (sizes * sizes);
    six_volumes_ += (mesh_.position(mesh_.source(3 * face)) - origin).dot(normal);
    return scaled_area_ < most_area_;
  }

  bool reach_neighbors(Index face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index opposite = mesh_.opposite(h);
      if (opposite == no_index) return false;
      Index& reached = reached_[opposite / 3];
      if (reached != 0 && reached != walk_) return false;
      if (reached == 0) faces_.push_back(opposite / 3);
      reached = walk_;
    }
    return true;
  }

  const EditableMesh& mesh_;
  double shortest_, most_area_;
  std::vector<Index> reached_;  ///< number of the walk that reached the face, 0 for none
  Index walk_ = 0;
  std::vector<Index> faces_;
  double area_ = 0, six_volumes_ = 0;
  double scaled_area_ = 0;  ///< in squares of the local size
};

}  // namespace

RemeshResult::RemovedComponents remove_thin_components(EditableMesh& mesh, double edge) {
  RemeshResult::RemovedComponents removed;
  AreaWalk component(mesh, edge);
  const std::vector<Index> seeds = indices_where(mesh.face_slots(), [&](Index face) {
    return mesh.has_face(face) && component.has_short_edge(face);
  });
  for (const Index seed : seeds) {
    if (!mesh.has_face(seed) || !component.walk(seed)) continue;
    ++removed.count;
    removed.faces += component.faces().size();
    removed.area += component.area();
    removed.volume += component.volume();
    for (const Index face : component.faces())
      for (Index h = 3 * face; h < 3 * face + 3; ++h) mesh.remove_vertex(mesh.source(h));
    for (const Index face : component.faces()) mesh.remove_face(face);
  }
  return removed;
}

}  // namespace transformesh
