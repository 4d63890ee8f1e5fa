#include "tm/geometry/predicates.h"

#include <CGAL/Mpzf.h>

#include <cmath>
#include <limits>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

using Exact = CGAL::Mpzf;

// This is twice Shewchuk's machine epsilon, so that the bounds hold in any rounding mode.
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double bound_3d = (7.0 + 64.0 * epsilon) * epsilon;
constexpr double bound_2d = (3.0 + 16.0 * epsilon) * epsilon;
// Below this a product may have lost bits to underflow, and no filter decides.
constexpr double underflow_guard = 1e-280;

// The sign of a computed determinant, or 0 where the error bound does not allow one.
int filtered_sign(double determinant, double bound) {
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return 0;
}

int exact_sign(const Exact& value) { return static_cast<int>(CGAL::sign(value)); }

std::array<Exact, 3> exact_difference(const Vec3& p, const Vec3& origin) {
  return {Exact(p[0]) - Exact(origin[0]), Exact(p[1]) - Exact(origin[1]),
          Exact(p[2]) - Exact(origin[2])};
}

std::array<Exact, 3> exact_cross(const std::array<Exact, 3>& a, const std::array<Exact, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Exact exact_dot(const std::array<Exact, 3>& a, const std::array<Exact, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<Exact, 3> exact_normal(const Triangle& t) {
  return exact_cross(exact_difference(t[1], t[0]), exact_difference(t[2], t[0]));
}

int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return exact_sign(exact_dot(exact_normal({a, b, c}), exact_difference(d, a)));
}

int exact_orient2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneProjection p) {
  const Exact left = (Exact(b[p.u]) - Exact(a[p.u])) * (Exact(c[p.v]) - Exact(a[p.v]));
  const Exact right = (Exact(b[p.v]) - Exact(a[p.v])) * (Exact(c[p.u]) - Exact(a[p.u]));
  return exact_sign(left - right);
}

constexpr PlaneProjection along(int axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

}  // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double bycz = by * cz, bzcy = bz * cy;
  const double bzcx = bz * cx, bxcz = bx * cz;
  const double bxcy = bx * cy, bycx = by * cx;
  const double determinant = dx * (bycz - bzcy) + dy * (bzcx - bxcz) + dz * (bxcy - bycx);
  const double permanent = std::abs(dx) * (std::abs(bycz) + std::abs(bzcy)) +
                           std::abs(dy) * (std::abs(bzcx) + std::abs(bxcz)) +
                           std::abs(dz) * (std::abs(bxcy) + std::abs(bycx));
  const int sign = filtered_sign(determinant, bound_3d * permanent + underflow_guard);
  return sign != 0 ? sign : exact_orient3d(a, b, c, d);
}

int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneProjection p) {
  const double left = (b[p.u] - a[p.u]) * (c[p.v] - a[p.v]);
  const double right = (b[p.v] - a[p.v]) * (c[p.u] - a[p.u]);
  const double bound = bound_2d * (std::abs(left) + std::abs(right)) + underflow_guard;
  const int sign = filtered_sign(left - right, bound);
  return sign != 0 ? sign : exact_orient2d(a, b, c, p);
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orient2d(a, b, c, along(0)) == 0 && orient2d(a, b, c, along(1)) == 0 &&
         orient2d(a, b, c, along(2)) == 0;
}

PlaneProjection projection_of(const Triangle& t) {
  const Vec3 b = t[1] - t[0];
  const Vec3 c = t[2] - t[0];
  const Vec3 normal(std::abs(b[1] * c[2] - b[2] * c[1]), std::abs(b[2] * c[0] - b[0] * c[2]),
                    std::abs(b[0] * c[1] - b[1] * c[0]));
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (normal[i] > normal[axis]) axis = i;
  }
  // The estimate may name a vanishing coordinate of a sliver: the exact sign has the last word.
  for (int i = 0; i < 3; ++i) {
    const PlaneProjection projection = along((axis + i) % 3);
    const int turn = orient2d(t[0], t[1], t[2], projection);
    if (turn > 0) return projection;
    if (turn < 0) return {projection.v, projection.u};
  }
  return {};
}

int normals_dot(const Triangle& first, const Triangle& second) {
  const Vec3 n = (first[1] - first[0]).cross(first[2] - first[0]);
  const Vec3 m = (second[1] - second[0]).cross(second[2] - second[0]);
  // Each normal coordinate is off by at most 4 epsilon of the product of the edge lengths.
  const double size = (first[1] - first[0]).norm() * (first[2] - first[0]).norm() *
                      (second[1] - second[0]).norm() * (second[2] - second[0]).norm();
  const int sign = filtered_sign(n.dot(m), 32 * epsilon * size + underflow_guard);
  return sign != 0 ? sign : exact_sign(exact_dot(exact_normal(first), exact_normal(second)));
}

int normals_cross(const Triangle& first, const Triangle& second, int coordinate) {
  const Vec3 n = (first[1] - first[0]).cross(first[2] - first[0]);
  const Vec3 m = (second[1] - second[0]).cross(second[2] - second[0]);
  const double size = (first[1] - first[0]).norm() * (first[2] - first[0]).norm() *
                      (second[1] - second[0]).norm() * (second[2] - second[0]).norm();
  const int sign = filtered_sign(n.cross(m)[coordinate], 32 * epsilon * size + underflow_guard);
  if (sign != 0) return sign;
  return exact_sign(
      exact_cross(exact_normal(first), exact_normal(second))[static_cast<std::size_t>(coordinate)]);
}

std::vector<Index> degenerate_faces(const Mesh& mesh) {
  constexpr std::size_t faces_per_task = 4096;
  std::vector<char> is_degenerate(mesh.faces.size());
  parallel_for(mesh.faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      is_degenerate[f] = collinear(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
  });
  std::vector<Index> result;
  for (std::size_t f = 0; f < is_degenerate.size(); ++f)
    if (is_degenerate[f]) result.push_back(static_cast<Index>(f));
  return result;
}

int compare_positions(const Vec3& a, const Vec3& b) {
  for (int i = 0; i < 3; ++i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

}  // namespace transformesh
