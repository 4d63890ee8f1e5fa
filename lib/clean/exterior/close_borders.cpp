#include "clean/exterior/close_borders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "mesh/disjoint_sets.h"
#include "mesh/edges.h"
#include "support/elementary/exponential.h"

namespace transformesh {
namespace {

constexpr double sheet_share = 1.0 / 3;  // least area vector of a sheet, per area
constexpr double body_share = 0.05;      // least volume of a body, per sphere of the same area
constexpr double far_behind = 10;        // in diagonals of the bounding box

using Loop = std::vector<Index>;

/// The power of two that brings points of extreme size near 1, so that products of their
/// coordinates neither overflow nor vanish; 1 for others.
double scale_of(const std::vector<Vec3>& points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  const bool is_usual = largest == 0 || (largest > 1e-60 && largest < 1e60);
  return is_usual ? 1 : std::ldexp(1, -std::ilogb(largest));
}

/// Measures of faces that are connected across edges of two faces.
struct Component {
  double area = 0;
  double volume = 0;                ///< six times that within the faces and the fans of centroids
  Vec3 area_vector = Vec3::Zero();  ///< twice the sum of the areas times the normals
  Vec3 border_sum = Vec3::Zero();   ///< of the points of all borders
  std::size_t border_points = 0;
};

bool is_sheet(const Component& component) {
  const double sphere = elementary::pow(component.area, 1.5) / (6 * std::sqrt(std::numbers::pi));
  return component.border_points > 0 &&
         component.area_vector.norm() / 2 >= sheet_share * component.area &&
         component.volume / 6 <= body_share * sphere;
}

class BorderCloser {
 public:
  BorderCloser(const WeldedMesh& welded, const std::vector<Loop>& loops);
  BorderClosure close() const;

 private:
  void connect_faces();
  void measure_faces();
  void measure_loop(const Loop& loop);
  Index face_of(const Loop& loop) const;
  Vec3 point(Index p) const { return welded_.points[p] * scale_; }
  Vec3 corner(Index face, int i) const { return point(welded_.faces[face][i]); }
  Vec3 centroid_of(const Loop& loop) const;
  Vec3 added_point(const Loop& loop, const Component& component) const;

  const WeldedMesh& welded_;
  const double scale_;  ///< of all that is measured
  const std::vector<Loop>& loops_;
  std::vector<Index> root_;            ///< per face: the first of its component
  std::vector<Component> components_;  ///< by root
  std::map<std::array<Index, 2>, Index> border_faces_;
  double diagonal_ = 0;
};

BorderCloser::BorderCloser(const WeldedMesh& welded, const std::vector<Loop>& loops)
    : welded_(welded),
      scale_(scale_of(welded.points)),
      loops_(loops),
      components_(welded.faces.size()) {
  connect_faces();
  measure_faces();
  for (const Loop& loop : loops) measure_loop(loop);
}

void BorderCloser::connect_faces() {
  const Edges edges(welded_.faces, welded_.points.size());
  DisjointSets sets(welded_.faces.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto halfedges = edges.halfedges(e);
    if (halfedges.size() == 2) {
      sets.join(halfedges[0] / 3, halfedges[1] / 3);
      continue;
    }
    for (const Index h : halfedges) {
      const Face& face = welded_.faces[h / 3];
      border_faces_.insert({{face[h % 3], face[(h % 3 + 1) % 3]}, h / 3});
    }
  }
  for (Index f = 0; f < welded_.faces.size(); ++f) root_.push_back(sets.find(f));
}

void BorderCloser::measure_faces() {
  Vec3 low = point(0);
  Vec3 high = low;
  for (Index p = 0; p < welded_.points.size(); ++p) {
    low = low.cwiseMin(point(p));
    high = high.cwiseMax(point(p));
  }
  diagonal_ = (high - low).norm();

  // Volumes are measured from a corner of the component, to stay accurate far from the origin.
  for (Index f = 0; f < welded_.faces.size(); ++f) {
    const Vec3 a = corner(f, 0);
    const Vec3 twice_area = (corner(f, 1) - a).cross(corner(f, 2) - a);
    Component& component = components_[root_[f]];
    component.area += twice_area.norm() / 2;
    component.volume += twice_area.dot(a - corner(root_[f], 0));
    component.area_vector += twice_area;
  }
}

void BorderCloser::measure_loop(const Loop& loop) {
  const Index face = face_of(loop);
  if (face == no_index) return;
  Component& component = components_[root_[face]];
  const Vec3 origin = corner(root_[face], 0);
  const Vec3 centroid = centroid_of(loop) - origin;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 from = point(loop[i]) - origin;
    const Vec3 to = point(loop[(i + 1) % loop.size()]) - origin;
    component.volume += to.cross(from).dot(centroid);
  }
  component.border_sum += centroid_of(loop) * static_cast<double>(loop.size());
  component.border_points += loop.size();
}

// A welded face along the loop. Faces without area may have a loop of their own, which bounds
// nothing and has no welded face: then no_index.
Index BorderCloser::face_of(const Loop& loop) const {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto found = border_faces_.find({loop[i], loop[(i + 1) % loop.size()]});
    if (found != border_faces_.end()) return found->second;
  }
  return no_index;
}

Vec3 BorderCloser::centroid_of(const Loop& loop) const {
  Vec3 centroid = Vec3::Zero();
  for (const Index p : loop) centroid += point(p) / static_cast<double>(loop.size());
  return centroid;
}

Vec3 BorderCloser::added_point(const Loop& loop, const Component& component) const {
  if (!is_sheet(component)) return centroid_of(loop);
  return component.border_sum / static_cast<double>(component.border_points) -
         component.area_vector.normalized() * (far_behind * diagonal_);
}

// A border has the direction of its faces, so its triangle fan has the opposite one.
BorderClosure BorderCloser::close() const {
  constexpr double farthest = std::numeric_limits<double>::max();
  BorderClosure closure;
  for (const Loop& loop : loops_) {
    const Index face = face_of(loop);
    if (face == no_index) continue;
    const Vec3 added = (added_point(loop, components_[root_[face]]) / scale_)
                           .cwiseMax(-farthest)
                           .cwiseMin(farthest);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      closure.triangles.push_back(
          {welded_.points[loop[(i + 1) % loop.size()]], welded_.points[loop[i]], added});
      closure.face_of.push_back(face);
    }
  }
  for (const Index root : root_) {
    closure.in_sheet.push_back(is_sheet(components_[root]) ? 1 : 0);
  }
  return closure;
}

}  // namespace

BorderClosure close_borders(const WeldedMesh& welded, const std::vector<Loop>& border_loops) {
  if (border_loops.empty()) return {};
  return BorderCloser(welded, border_loops).close();
}

}  // namespace transformesh
