#include "tm/remesh/small_components.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tm/remesh/halfedges/where.h"
#include "tm/support/elementary/exponential.h"

namespace transformesh {
namespace {

/// Walks over a component as long as all its edges are short, and measures it on the way.
class ComponentWalk {
 public:
  ComponentWalk(const EditableMesh& mesh, double edge)
      : mesh_(mesh), limit_(edge * edge), reached_(mesh.face_slots(), 0) {}

  const std::vector<Index>& faces() const { return faces_; }
  bool has_border() const { return has_border_; }
  double volume() const { return six_volumes_ / 6; }
  double mean_size() const { return sizes_ / (3.0 * static_cast<double>(faces_.size())); }

  /// False where the face was reached before, or a long edge shows that the component is not small.
  bool walk(Index seed) {
    if (reached_[seed] || !has_short_edges(seed)) return false;
    faces_.assign(1, seed);
    reached_[seed] = ++walk_;
    has_border_ = false;
    six_volumes_ = 0;
    sizes_ = 0;
    const Vec3& origin = mesh_.position(mesh_.source(3 * seed));
    for (std::size_t i = 0; i < faces_.size(); ++i) {  // NOLINT: visit() adds to them
      if (!has_short_edges(faces_[i]) || !visit(faces_[i], origin)) return false;
    }
    return true;
  }

  bool has_short_edges(Index face) const {
    const auto [a, b, c] = mesh_.scaled_squared_lengths(face);
    return a < limit_ && b < limit_ && c < limit_;
  }

 private:
  /// False next to a face that an earlier walk reached, which then met a long edge.
  bool visit(Index face, const Vec3& origin) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index opposite = mesh_.opposite(h);
      sizes_ += mesh_.size(mesh_.source(h));
      has_border_ |= opposite == no_index;
      if (opposite == no_index) continue;
      Index& reached = reached_[opposite / 3];
      if (reached != 0 && reached != walk_) return false;
      if (reached == 0) faces_.push_back(opposite / 3);
      reached = walk_;
    }
    six_volumes_ += (mesh_.position(mesh_.source(3 * face)) - origin).dot(mesh_.face_normal(face));
    return true;
  }

  const EditableMesh& mesh_;
  double limit_;
  std::vector<Index> reached_;  ///< number of the walk that reached the face, 0 for none
  Index walk_ = 0;
  std::vector<Index> faces_;
  bool has_border_ = false;
  double six_volumes_ = 0;
  double sizes_ = 0;  ///< sum over the corners of the faces
};

void remove_faces(EditableMesh& mesh, const std::vector<Index>& faces) {
  for (const Index face : faces) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) mesh.remove_vertex(mesh.source(h));
  }
  for (const Index face : faces) mesh.remove_face(face);
}

}  // namespace

std::size_t remove_small_components(EditableMesh& mesh, double edge, bool keep_border) {
  std::size_t removed = 0;
  ComponentWalk component(mesh, edge);
  const std::vector<Index> seeds = indices_where(mesh.face_slots(), [&](Index face) {
    return mesh.has_face(face) && component.has_short_edges(face);
  });
  for (const Index face : seeds) {
    if (!mesh.has_face(face) || !component.walk(face)) continue;
    if (keep_border && component.has_border()) continue;
    const double diameter = edge * component.mean_size();
    if (std::abs(component.volume()) >= std::numbers::pi / 6 * elementary::pow(diameter, 3))
      continue;
    remove_faces(mesh, component.faces());
    ++removed;
  }
  return removed;
}

}  // namespace transformesh
