/// Random points that are defined by edges and faces (exact_point.h), and their positions as
/// rationals. The formulas of the positions are independent of the library.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "geometry/numbers/exact_point.h"
#include "helpers/random.h"
#include "helpers/rational.h"

namespace transformesh::test {

struct Plane {
  RationalPoint normal;
  Rational offset;
};

inline Plane plane_of(const std::vector<Vec3>& p, const Face& f) {
  const RationalPoint a = exact(p[f[0]]);
  const RationalPoint n = cross(minus(exact(p[f[1]]), a), minus(exact(p[f[2]]), a));
  return {n, dot(n, a)};
}

inline RationalPoint solve_line_plane(const Vec3& u, const Vec3& v, const Plane& plane) {
  const RationalPoint a = exact(u), step = minus(exact(v), a);
  const Rational t = (plane.offset - dot(plane.normal, a)) / dot(plane.normal, step);
  return {a[0] + t * step[0], a[1] + t * step[1], a[2] + t * step[2]};
}

/// Solves the three plane equations by Gaussian elimination.
inline RationalPoint solve_planes(const std::array<Plane, 3>& planes) {
  std::array<std::array<Rational, 4>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    rows[i] = {planes[i].normal[0], planes[i].normal[1], planes[i].normal[2], planes[i].offset};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    while (rows[pivot][k] == 0) ++pivot;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == k) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = 0; j < 4; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  return {rows[0][3] / rows[0][0], rows[1][3] / rows[1][1], rows[2][3] / rows[2][2]};
}

inline int sign(const Rational& x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

/// Three faces through a common region and lines through them, on a lattice, so that points often
/// coincide or are collinear. Coordinates may be far from the origin, where doubles are coarse.
struct Scene {
  std::vector<Vec3> positions;
  std::vector<Face> faces;
  std::vector<ExactPoint> points;
  std::vector<RationalPoint> truth;
};

inline Vec3 lattice_point(Random& random, double shift) {
  const auto coordinate = [&] { return std::floor(random.uniform(0, 5)) + shift; };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

inline Scene random_scene(std::uint64_t seed, double shift) {
  Random random(seed);
  Scene scene;
  while (scene.faces.size() < 6) {
    const auto base = static_cast<Index>(scene.positions.size());
    std::array<Vec3, 3> t;
    for (Vec3& p : t) p = lattice_point(random, shift);
    if (collinear(t[0], t[1], t[2])) continue;
    scene.positions.insert(scene.positions.end(), t.begin(), t.end());
    scene.faces.push_back({base, base + 1, base + 2});
  }
  return scene;
}

inline bool is_inside(const Scene& scene, Index face, const RationalPoint& p) {
  const Face& f = scene.faces[face];
  const Plane plane = plane_of(scene.positions, f);
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint a = exact(scene.positions[f[i]]);
    const RationalPoint b = exact(scene.positions[f[(i + 1) % 3]]);
    if (dot(plane.normal, cross(minus(b, a), minus(p, a))) < 0) return false;
  }
  return true;
}

inline void add_points(Scene& scene) {
  const ExactGeometry geometry(scene.positions, scene.faces);
  for (Index v = 0; v < scene.positions.size(); ++v) {
    scene.points.push_back(geometry.given(v));
    scene.truth.push_back(exact(scene.positions[v]));
  }
  for (Index f = 0; f < scene.faces.size(); ++f) {
    const Triangle t{scene.positions[scene.faces[f][0]], scene.positions[scene.faces[f][1]],
                     scene.positions[scene.faces[f][2]]};
    for (Index v = 0; v < scene.positions.size(); v += 2) {
      const Index w = (v + 5) % static_cast<Index>(scene.positions.size());
      if (orient3d(t[0], t[1], t[2], scene.positions[v]) *
              orient3d(t[0], t[1], t[2], scene.positions[w]) >=
          0) {
        continue;
      }
      scene.points.push_back(geometry.point(PointDefinition::line_plane(v, w, f)));
      scene.truth.push_back(solve_line_plane(scene.positions[v], scene.positions[w],
                                             plane_of(scene.positions, scene.faces[f])));
    }
  }
  for (Index f = 0; f < 6; ++f) {
    for (Index g = f + 1; g < 6; ++g) {
      for (Index h = g + 1; h < 6; ++h) {
        const std::array<Plane, 3> planes{plane_of(scene.positions, scene.faces[f]),
                                          plane_of(scene.positions, scene.faces[g]),
                                          plane_of(scene.positions, scene.faces[h])};
        if (dot(planes[0].normal, cross(planes[1].normal, planes[2].normal)) == 0) continue;
        const RationalPoint p = solve_planes(planes);
        if (!is_inside(scene, f, p) || !is_inside(scene, g, p) || !is_inside(scene, h, p)) continue;
        scene.points.push_back(geometry.three_planes(h, f, g));
        scene.truth.push_back(p);
      }
    }
  }
}

}  // namespace transformesh::test
