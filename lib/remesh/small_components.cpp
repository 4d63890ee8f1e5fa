#include "remesh/small_components.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "remesh/halfedges/select_slots.h"
#include "support/elementary/exponential.h"

namespace transformesh {
namespace {

/// Traverses a component while all its edges are short, and measures it.
class ComponentWalk {
 public:
  ComponentWalk(const EditableMesh& mesh, double edge)
      : mesh_(mesh), limit_(edge * edge), reached_(mesh.face_slots(), 0) {}

  const std::vector<Index>& faces() const { return faces_; }
  bool has_border() const { return has_border_; }
  double volume() const { return six_volumes_ / 6; }
  double mean_size() const { return sizes_ / (3.0 * static_cast<double>(faces_.size())); }

  /// Returns false if the face was reached before or the component has a long edge.
  bool walk(Index seed) {
    if (reached_[seed] || !has_short_edges(seed)) return false;
    faces_.assign(1, seed);
    reached_[seed] = ++walk_;
    has_border_ = false;
    six_volumes_ = 0;
    sizes_ = 0;
    const Vec3& origin = mesh_.position(mesh_.source(3 * seed));
    for (std::size_t i = 0; i < faces_.size(); ++i) {  // NOLINT: visit() adds to faces_
      if (!has_short_edges(faces_[i]) || !visit(faces_[i], origin)) return false;
    }
    return true;
  }

  bool has_short_edges(Index face) const {
    const auto [a, b, c] = mesh_.scaled_squared_lengths(face);
    return a < limit_ && b < limit_ && c < limit_;
  }

 private:
  /// Measures the face and adds its unvisited neighbors to faces_. Returns false if a neighbor was
  /// reached by an earlier walk, which then found a long edge.
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
  std::vector<Index> reached_;  ///< for each face the number of the walk that reached it, or 0
  Index walk_ = 0;
  std::vector<Index> faces_;
  bool has_border_ = false;
  double six_volumes_ = 0;
  double sizes_ = 0;  ///< sum of the wanted edge lengths at the faces' corners
};

/// Returns the second longest side of the bounding box of the faces along their principal axes.
double width_of(const EditableMesh& mesh, const std::vector<Index>& faces) {
  const Vec3 origin = mesh.position(mesh.source(3 * faces[0]));
  Vec3 sum = Vec3::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  const auto for_each_corner = [&](const auto& visit) {
    for (const Index face : faces)
      for (const Vec3& corner : mesh.triangle(face)) visit(Vec3(corner - origin));
  };
  for_each_corner([&](const Vec3& p) {
    sum += p;
    squares += p * p.transpose();
  });
  const double count = 3.0 * static_cast<double>(faces.size());
  const Eigen::Matrix3d covariance = squares / count - sum * sum.transpose() / (count * count);
  const Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  Vec3 low = Vec3::Constant(HUGE_VAL);
  Vec3 high = -low;
  for_each_corner([&](const Vec3& p) {
    const Vec3 along = axes.transpose() * p;
    low = low.cwiseMin(along);
    high = high.cwiseMax(along);
  });
  Vec3 sides = high - low;
  std::sort(sides.data(), sides.data() + 3);
  return sides[1];
}

double area_of(const EditableMesh& mesh, const std::vector<Index>& faces) {
  double area = 0;
  for (const Index face : faces) area += 0.5 * mesh.face_normal(face).norm();
  return area;
}

void remove_faces(EditableMesh& mesh, const std::vector<Index>& faces) {
  for (const Index face : faces) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) mesh.remove_vertex(mesh.source(h));
  }
  for (const Index face : faces) mesh.remove_face(face);
}

}  // namespace

RemeshResult::RemovedComponents remove_small_components(EditableMesh& mesh, double edge,
                                                        bool keep_border) {
  RemeshResult::RemovedComponents removed;
  ComponentWalk component(mesh, edge);
  const std::vector<Index> seeds = indices_where(mesh.face_slots(), [&](Index face) {
    return mesh.has_face(face) && component.has_short_edges(face);
  });
  for (const Index face : seeds) {
    if (!mesh.has_face(face) || !component.walk(face)) continue;
    if (keep_border && component.has_border()) continue;
    const double length = edge * component.mean_size();
    const double volume = std::abs(component.volume());
    if (volume >= std::numbers::pi / 6 * elementary::pow(length, 3)) continue;
    if (width_of(mesh, component.faces()) >= length) continue;
    ++removed.count;
    removed.faces += component.faces().size();
    removed.area += area_of(mesh, component.faces());
    removed.volume += volume;
    remove_faces(mesh, component.faces());
  }
  return removed;
}

}  // namespace transformesh
