#include "shapes/spheres.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes/assembly.h"
#include "support/elementary/exponential.h"
#include "support/elementary/trigonometric.h"
#include "support/random.h"

namespace transformesh::shapes {
namespace {

constexpr std::array<Face, 20> icosahedron_faces = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

std::array<Vec3, 12> icosahedron_corners() {
  constexpr double t = std::numbers::phi;
  std::array<Vec3, 12> corners = {{{-1, t, 0},
                                   {1, t, 0},
                                   {-1, -t, 0},
                                   {1, -t, 0},
                                   {0, -1, t},
                                   {0, 1, t},
                                   {0, -1, -t},
                                   {0, 1, -t},
                                   {t, 0, -1},
                                   {t, 0, 1},
                                   {-t, 0, -1},
                                   {-t, 0, 1}}};
  for (Vec3& corner : corners) corner.normalize();
  return corners;
}

/// Divides the icosahedron. Faces share the points on their common corners and edges.
class GeodesicBuilder {
 public:
  explicit GeodesicBuilder(std::size_t frequency) : n_(frequency) {
    mesh_.positions.reserve(10 * n_ * n_ + 2);
    mesh_.faces.reserve(20 * n_ * n_);
    for (auto& row : edge_start_) row.fill(no_index);
    for (const Vec3& corner : corners_) mesh_.positions.push_back(corner);
  }

  Mesh build() {
    for (const Face& face : icosahedron_faces) cut(face);
    return std::move(mesh_);
  }

 private:
  // Adds points by rows from the first corner of the face; row i has i + 1 points.
  void cut(const Face& face) {
    std::vector<Index> row = {face[0]};
    for (std::size_t i = 1; i <= n_; ++i) {
      std::vector<Index> next(i + 1);
      for (std::size_t j = 0; j <= i; ++j) next[j] = grid_point(face, i, j);
      for (std::size_t j = 0; j < i; ++j) {
        mesh_.faces.push_back({row[j], next[j], next[j + 1]});
        if (j + 1 < i) mesh_.faces.push_back({row[j], next[j + 1], row[j + 1]});
      }
      row = std::move(next);
    }
  }

  Index grid_point(const Face& face, std::size_t i, std::size_t j) {
    if (i == n_ && j == 0) return face[1];
    if (i == n_ && j == n_) return face[2];
    if (j == 0) return edge_point(face[0], face[1], i);
    if (j == i) return edge_point(face[0], face[2], i);
    if (i == n_) return edge_point(face[1], face[2], j);
    return add(corners_[face[0]] * static_cast<double>(n_ - i) +
               corners_[face[1]] * static_cast<double>(i - j) +
               corners_[face[2]] * static_cast<double>(j));
  }

  // Returns the index of point `step` on an edge between two corners, which has n equal parts. The
  // points are stored once per edge, starting at the corner with the lower index.
  Index edge_point(Index from, Index to, std::size_t step) {
    if (from > to) {
      std::swap(from, to);
      step = n_ - step;
    }
    Index& start = edge_start_[from][to];
    if (start == no_index) {
      start = static_cast<Index>(mesh_.positions.size());
      for (std::size_t k = 1; k < n_; ++k)
        add(corners_[from] * static_cast<double>(n_ - k) + corners_[to] * static_cast<double>(k));
    }
    return start + static_cast<Index>(step - 1);
  }

  Index add(const Vec3& point) {
    mesh_.positions.push_back(point.normalized());
    return static_cast<Index>(mesh_.positions.size() - 1);
  }

  const std::size_t n_;
  const std::array<Vec3, 12> corners_ = icosahedron_corners();
  std::array<std::array<Index, 12>, 12> edge_start_;
  Mesh mesh_;
};

/// Distributes `faces` over spheres by area. Each sphere has 20 n^2 faces for some n; the following
/// spheres compensate for the rounding.
Mesh spheres_of(const std::vector<Vec3>& centers, const std::vector<double>& radii,
                std::size_t faces) {
  double area_left = 0;
  for (const double radius : radii) area_left += radius * radius;
  auto faces_left = static_cast<double>(faces);
  Mesh mesh;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const double area = radii[i] * radii[i];
    Mesh sphere = geodesic_sphere(geodesic_frequency(faces_left * area / area_left));
    faces_left -= static_cast<double>(sphere.faces.size());
    area_left -= area;
    transform(sphere, radii[i] * generic_rotation(static_cast<unsigned>(i)), centers[i]);
    append(mesh, sphere);
  }
  return mesh;
}

Vec3 random_point_of_ball(Random& random, double radius) {
  Vec3 point;
  do {
    for (double& coordinate : point) coordinate = random.uniform(-radius, radius);
  } while (point.squaredNorm() > radius * radius);
  return point;
}

}  // namespace

Mesh geodesic_sphere(std::size_t frequency) { return GeodesicBuilder(frequency).build(); }

std::size_t geodesic_frequency(double faces) {
  const double n = std::floor(std::sqrt(std::max(faces, 20.0) / 20));
  const bool next_is_closer = 20 * (n + 1) * (n + 1) - faces < faces - 20 * n * n;
  return static_cast<std::size_t>(next_is_closer ? n + 1 : n);
}

double geodesic_inner_radius(std::size_t frequency) {
  const Mesh mesh = geodesic_sphere(frequency);
  double inner = 1;
  for (const auto& [a, b, c] : mesh.faces) {
    const Vec3& corner = mesh.positions[a];
    const Vec3 normal = (mesh.positions[b] - corner).cross(mesh.positions[c] - corner);
    inner = std::min(inner, corner.dot(normal.normalized()));
  }
  return inner;
}

Mesh two_spheres(double radius, double gap, std::size_t faces) {
  const Vec3 offset(radius + gap / 2, 0, 0);
  return spheres_of({-offset, offset}, {radius, radius}, faces);
}

Mesh dented_sphere(double radius, std::size_t faces) {
  const auto dent = [](const Vec3& direction, const Vec3& axis, double depth, double width) {
    const double distance = (direction - axis.normalized()).squaredNorm();
    return depth * elementary::exp(-distance / (2 * width * width));
  };
  Mesh mesh = geodesic_sphere(geodesic_frequency(static_cast<double>(faces)));
  for (Vec3& position : mesh.positions) {
    const Vec3 n = position;
    const double relief = 0.05 * elementary::sin(4 * n.x() + 1) * elementary::cos(5 * n.y()) +
                          0.04 * elementary::sin(6 * n.z());
    const double dents =
        dent(n, {0.8, 0.5, 0.33}, 0.30, 0.25) + dent(n, {-0.6, 0.7, -0.2}, 0.18, 0.2);
    position = radius * (1 + relief - dents) * n;
  }
  return mesh;
}

Mesh many_spheres(std::size_t count, std::uint64_t seed, std::size_t faces) {
  // Radius of the ball that contains the spheres. The sum of the spheres' volumes is about twice
  // its volume.
  constexpr double world = 1.2;
  const double typical = std::min(0.6, world * elementary::cbrt(4 / static_cast<double>(count)));
  Random random(seed);
  std::vector<Vec3> centers;
  std::vector<double> radii;
  for (std::size_t i = 0; i < count; ++i) {
    radii.push_back(typical * random.uniform(0.6, 1));
    centers.push_back(random_point_of_ball(random, world - radii.back()));
  }
  return spheres_of(centers, radii, faces);
}

}  // namespace transformesh::shapes
