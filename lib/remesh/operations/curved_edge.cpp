#include "remesh/operations/curved_edge.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

#include "mesh/triangle.h"
#include "remesh/halfedges/triangle_quality.h"

namespace transformesh {
namespace {

/// The cosine of 40 degrees, the usual feature angle. Faces with equal edges on a smooth surface
/// turn by this angle if the radius of curvature is below the edge length. A quadric does not
/// describe such a surface.
constexpr double crease_cosine = 0.7660444431189780;
/// The cosine of 60 degrees. Faces whose angle to the plane is larger do not belong to a height
/// field.
constexpr double field_cosine = 0.5;
/// A height above the edge of more than this share of its length belongs to a fold, not to a smooth
/// surface. On a sphere whose faces turn by 40 degrees the share is 0.16.
constexpr double largest_height = 0.2;
/// Share of the largest diagonal entry that is added to the normal equations, so that curvatures
/// that no vertex determines become 0. Without damping, an edge whose only neighbors are the two
/// apexes has no solution; more than 1e-3 flattens regular neighborhoods.
constexpr double damping = 1e-6;
/// The cosine of 45 degrees. A vertex at which a crease turns by more than 45 degrees is a corner.
constexpr double corner_cosine = 0.7071067811865476;

bool is_crease(const EditableMesh& mesh, Index h) {
  if (mesh.is_border(h) || mesh.is_feature(h)) return true;
  return turns(mesh.face_normal(h / 3), mesh.face_normal(mesh.opposite(h) / 3), crease_cosine);
}

/// Visits the neighbors of a halfedge's source that can be reached across smooth edges, through
/// faces whose normals differ from `normal` by at most 60 degrees. Returns true if these are all
/// faces at the vertex.
template <class Visit>
bool visit_sector(const EditableMesh& mesh, Index start, const Vec3& normal, const Visit& visit) {
  const auto is_passable = [&](Index edge) {
    if (is_crease(mesh, edge)) return false;
    const Index across = mesh.opposite(edge);
    return !turns(normal, mesh.face_normal(across / 3), field_cosine);
  };
  for (Index h = start;;) {
    const Index edge = previous_halfedge(h);
    visit(mesh.source(edge));
    if (!is_passable(edge)) break;
    h = mesh.opposite(edge);
    if (h == start) return true;
  }
  for (Index h = start;;) {
    visit(mesh.target(h));
    if (!is_passable(h)) return false;
    h = next_halfedge(mesh.opposite(h));
  }
}

/// Solves least squares in Count unknowns, which are slightly pulled to 0.
template <int Count>
class Fit {
 public:
  using Row = Eigen::Matrix<double, Count, 1>;

  void add(const Row& row, double value, double weight) {
    matrix_ += weight * row * row.transpose();
    right_ += weight * value * row;
  }
  Row solution() {
    const double added = damping * matrix_.diagonal().maxCoeff();
    if (!(added > 0)) return Row::Zero();
    matrix_.diagonal().array() += added;
    return matrix_.ldlt().solve(right_);
  }

 private:
  Eigen::Matrix<double, Count, Count> matrix_ = Eigen::Matrix<double, Count, Count>::Zero();
  Row right_ = Row::Zero();
};

/// A coordinate system of a plane and its normal, with a given unit of length.
struct Frame {
  Vec3 origin, x, y, z;
  double unit;

  Vec3 local(const Vec3& point) const {
    const Vec3 offset = (point - origin) / unit;
    return {offset.dot(x), offset.dot(y), offset.dot(z)};
  }
};

/// Nearer vertices have larger weights, because the error of a quadric grows with the third power
/// of distance.
double weight_of(const Vec3& point) {
  const double squared = point.squaredNorm();
  return 1 / (squared * squared);
}

Vec3 smooth_midpoint(const EditableMesh& mesh, Index h) {
  const Index across = mesh.opposite(h);
  const std::array<Index, 2> ends{mesh.source(h), mesh.target(h)};
  const Vec3& first = mesh.position(ends[0]);
  const Vec3 edge = mesh.position(ends[1]) - first;
  const Vec3 middle = first + 0.5 * edge;
  const Vec3 normal =
      (mesh.face_normal(h / 3).normalized() + mesh.face_normal(across / 3).normalized())
          .normalized();
  const double length = edge.norm();
  const Frame frame{middle, edge / length, normal.cross(edge) / length, normal, length};

  Fit<4> fit;
  const auto add = [&](Index vertex) {
    if (vertex == ends[0] || vertex == ends[1]) return;
    const Vec3 p = frame.local(mesh.position(vertex));
    if (!(p.squaredNorm() > 0)) return;
    fit.add({p.x() * p.x() - 0.25, p.y(), p.x() * p.y(), p.y() * p.y()}, p.z(), weight_of(p));
  };
  visit_sector(mesh, h, normal, add);
  visit_sector(mesh, across, normal, add);
  const double height = -0.25 * fit.solution()[0];
  if (!(std::abs(height) <= largest_height)) return middle;
  return middle + height * length * normal;
}

/// Returns the vertex to which a crease continues straight beyond the target of one of its
/// halfedges; no_index if the crease ends, branches or turns at the target.
Index crease_beyond(const EditableMesh& mesh, Index source, Index target) {
  Index beyond = no_index;
  int count = 0;
  mesh.for_each_neighbor(target, [&](Index neighbor, Index h) {
    if (neighbor == source || !is_crease(mesh, h)) return;
    beyond = neighbor;
    ++count;
  });
  if (count != 1) return no_index;
  const Vec3 in = mesh.position(target) - mesh.position(source);
  const Vec3 out = mesh.position(beyond) - mesh.position(target);
  return turns(in, out, corner_cosine) ? no_index : beyond;
}

/// Returns the height, above the middle of the chord from `from` to `to`, of the parabola through
/// `from`, `to` and `beyond`. The parameter of each point is its distance from the point before.
Vec3 parabola_height(const Vec3& from, const Vec3& to, const Vec3& beyond) {
  const double step = (to - from).norm();
  const double next = (beyond - to).norm();
  const Vec3 second = ((beyond - to) / next - (to - from) / step) / (step + next);
  return -0.25 * step * step * second;
}

/// The mean of the two parabolas, each with one neighbor beyond the edge, is a cubic through all
/// four vertices if these are evenly spaced. Reference: Dyn, Levin & Gregory, "A 4-point
/// interpolatory subdivision scheme for curve design", Computer Aided Geometric Design 1987.
Vec3 crease_midpoint(const EditableMesh& mesh, Index h) {
  const Index source = mesh.source(h);
  const Index target = mesh.target(h);
  const Vec3& a = mesh.position(source);
  const Vec3& b = mesh.position(target);
  Vec3 height = Vec3::Zero();
  int count = 0;
  const Index after = crease_beyond(mesh, source, target);
  const Index before = crease_beyond(mesh, target, source);
  if (after != no_index) height += parabola_height(a, b, mesh.position(after));
  if (before != no_index) height += parabola_height(b, a, mesh.position(before));
  count = (after != no_index ? 1 : 0) + (before != no_index ? 1 : 0);
  const Vec3 middle = a + 0.5 * (b - a);
  return count == 0 ? middle : Vec3(middle + height / count);
}

}  // namespace

Vec3 curved_midpoint(const EditableMesh& mesh, Index halfedge) {
  return is_crease(mesh, halfedge) ? crease_midpoint(mesh, halfedge)
                                   : smooth_midpoint(mesh, halfedge);
}

Vec3 lifted_onto_surface(const EditableMesh& mesh, Index vertex, const Vec3& target) {
  const Vec3& center = mesh.position(vertex);
  Vec3 normal = Vec3::Zero();
  mesh.for_each_outgoing(vertex, [&](Index h) { normal += mesh.face_normal(h / 3); });
  const Vec3 shift = target - center;
  const double length = shift.norm();
  if (!(length > 0) || !(normal.squaredNorm() > 0)) return target;
  normal.normalize();
  const Vec3 along = (shift - shift.dot(normal) * normal).normalized();
  const double reach = std::sqrt(mesh.squared_length(mesh.outgoing(vertex)));
  const Frame frame{center, along, normal.cross(along), normal, reach};

  Fit<5> fit;
  const bool is_whole = visit_sector(mesh, mesh.outgoing(vertex), normal, [&](Index neighbor) {
    const Vec3 p = frame.local(mesh.position(neighbor));
    if (!(p.squaredNorm() > 0)) return;
    fit.add({p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y()}, p.z(), weight_of(p));
  });
  if (!is_whole) return target;
  const auto solution = fit.solution();
  const Vec3 place = frame.local(target);
  const double x = place.x();
  const double height = x * (solution[0] + x * solution[2]);
  if (!(std::abs(height) <= largest_height * std::abs(x))) return target;
  return target + (height - place.z()) * reach * normal;
}

}  // namespace transformesh
