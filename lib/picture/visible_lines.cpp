#include "picture/visible_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/camera.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t items_per_task = 4096;  ///< affects time only
constexpr double least_determinant = 1e-9;    ///< relative; faces observed edge-on hide nothing
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The part of a segment on which linear functions are not negative. Its ends are parameters in [0,
/// 1] along the segment.
struct Interval {
  double from = 0;
  double to = 1;

  bool empty() const { return !(from < to); }
  /// Keeps only the part on which a linear function is not negative. `at_0` and `at_1` are its
  /// values at the ends of the segment.
  void keep(double at_0, double at_1) {
    if (at_0 < 0 && at_1 < 0) to = from;
    if (at_0 < 0 && at_1 >= 0) from = std::max(from, at_0 / (at_0 - at_1));
    if (at_0 >= 0 && at_1 < 0) to = std::min(to, at_0 / (at_0 - at_1));
  }
};

/// Returns the part of a segment in front of the camera and in the image. `a` and `b` are
/// projections of its ends.
Interval inside_image(const Vec3& a, const Vec3& b, int width, int height) {
  Interval inside;
  const double nearest = 1e-9 * std::max(std::abs(a.z()), std::abs(b.z()));
  inside.keep(a.z() - nearest, b.z() - nearest);
  inside.keep(a.x() + 0.5 * a.z(), b.x() + 0.5 * b.z());
  inside.keep(a.y() + 0.5 * a.z(), b.y() + 0.5 * b.z());
  inside.keep((width - 0.5) * a.z() - a.x(), (width - 0.5) * b.z() - b.x());
  inside.keep((height - 0.5) * a.z() - a.y(), (height - 0.5) * b.z() - b.y());
  return inside;
}

Vec3 image_of(const Vec3& projected) {
  return {projected.x() / projected.z(), projected.y() / projected.z(), projected.z()};
}

/// Returns the bounding box of the image of a face: everything if the face reaches behind the
/// camera, nothing if it is entirely behind.
FloatBox covered(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double nearest = std::min({a.z(), b.z(), c.z()});
  const double farthest = std::max({a.z(), b.z(), c.z()});
  if (farthest <= 0) return float_box(Vec3::Constant(-infinite), Vec3::Constant(-infinite));
  if (nearest <= 0) return float_box(Vec3::Constant(-infinite), Vec3::Constant(infinite));
  const Vec3 u = image_of(a);
  const Vec3 v = image_of(b);
  const Vec3 w = image_of(c);
  return float_box(u.cwiseMin(v).cwiseMin(w), u.cwiseMax(v).cwiseMax(w));
}

/// True if the face is observed well enough to hide anything.
bool can_hide(const EdgeFunctions& face, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double size = face.edge[0].norm() * a.norm() + face.edge[1].norm() * b.norm() +
                      face.edge[2].norm() * c.norm();
  return face.depth_numerator > least_determinant * size;
}

/// Returns the part of a segment that the face hides. `a` and `b` are projections of the ends.
Interval hidden_by(const EdgeFunctions& face, const Vec3& a, const Vec3& b) {
  Interval hidden;
  double sum_a = 0;
  double sum_b = 0;
  for (const Vec3& edge : face.edge) {
    const double at_a = edge.dot(a);
    const double at_b = edge.dot(b);
    hidden.keep(at_a, at_b);
    sum_a += at_a;
    sum_b += at_b;
  }
  // A point is behind a face if it is farther from the camera by more than this fraction of the
  // face's distance.
  constexpr double least_distance = 1e-6;
  const double at_face = (1 + least_distance) * face.depth_numerator;
  hidden.keep(sum_a - at_face, sum_b - at_face);
  return hidden;
}

/// Subtracts `others` from `whole`.
VisibleLines::Parts without(const Interval& whole, std::vector<Interval>& others) {
  std::sort(others.begin(), others.end(), [](const Interval& a, const Interval& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
  VisibleLines::Parts parts;
  double place = whole.from;
  for (const Interval& other : others) {
    if (other.from >= whole.to) break;
    if (other.from > place) parts.emplace_back(place, other.from);
    place = std::max(place, other.to);
  }
  if (place < whole.to) parts.emplace_back(place, whole.to);
  return parts;
}

}  // namespace

VisibleLines::VisibleLines(const Mesh& mesh, const Camera& camera)
    : camera_(camera), faces_(mesh.faces.size()) {
  std::vector<FloatBox> boxes(mesh.faces.size());
  parallel_for(faces_.size(), items_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const Face& face = mesh.faces[f];
      const Vec3 a = camera.project(mesh.positions[face[0]]);
      const Vec3 b = camera.project(mesh.positions[face[1]]);
      const Vec3 c = camera.project(mesh.positions[face[2]]);
      faces_[f] = edge_functions(a, b, c);
      if (!can_hide(faces_[f], a, b, c)) faces_[f] = {};
      boxes[f] = covered(a, b, c);
    }
  });
  bvh_ = Bvh(boxes);
}

VisibleLines::Parts VisibleLines::parts(const Vec3& from, const Vec3& to,
                                        std::span<const Index> own) const {
  const Vec3 a = camera_.project(from);
  const Vec3 b = camera_.project(to);
  const Interval inside = inside_image(a, b, camera_.width, camera_.height);
  if (inside.empty()) return {};

  // Candidates are faces whose image overlaps the image of the segment and that are not entirely
  // behind the segment.
  const Vec3 start = image_of(a + inside.from * (b - a));
  const Vec3 end = image_of(a + inside.to * (b - a));
  if (!start.allFinite() || !end.allFinite()) return {};
  Vec3 low = start.cwiseMin(end);
  low.z() = -infinite;
  std::vector<Interval> hidden;
  bvh_.visit_overlaps(float_box(low, start.cwiseMax(end)), [&](Index face) {
    const bool is_own = std::find(own.begin(), own.end(), face) != own.end();
    if (is_own || !(faces_[face].depth_numerator > 0)) return true;
    const Interval part = hidden_by(faces_[face], a, b);
    if (!part.empty()) hidden.push_back(part);
    return true;
  });
  return without(inside, hidden);
}

}  // namespace transformesh
