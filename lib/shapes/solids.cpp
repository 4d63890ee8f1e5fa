#include "shapes/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes/implicit.h"
#include "support/elementary/trigonometric.h"

namespace transformesh::shapes {
namespace {

using std::numbers::pi;
using Vec2 = Eigen::Vector2d;

/// Approximate signed distance in the plane from the outline of a plate with holes.
struct PerforatedPlate {
  std::vector<Vec2> holes;
  double hole_radius = 1;
  double wall = 1.4;  // width of the walls between and around holes
  double hub = 0;     // radius of the central disk

  explicit PerforatedPlate(long count) {
    const double spacing = 2 * hole_radius + wall;
    const double ring =
        count == 1 ? 0 : spacing / (2 * elementary::sin(pi / static_cast<double>(count)));
    for (long i = 0; i < count; ++i) {
      const double angle = pi / 2 + 2 * pi * static_cast<double>(i) / static_cast<double>(count);
      holes.emplace_back(ring * Vec2(elementary::cos(angle), elementary::sin(angle)));
    }
    hub = count < 3 ? 0 : ring;
    scale(1.2 / (ring + hole_radius + wall));
  }

  double distance(const Vec2& point) const {
    double outline = hub > 0 ? point.norm() - hub : 1e9;
    double hole = -1e9;
    for (const Vec2& center : holes) {
      const double from_center = (point - center).norm();
      outline = smooth_minimum(outline, from_center - hole_radius - wall, wall / 2);
      hole = std::max(hole, hole_radius - from_center);
    }
    return std::max(outline, hole);
  }

 private:
  void scale(double factor) {
    for (Vec2& center : holes) center *= factor;
    hole_radius *= factor;
    wall *= factor;
    hub *= factor;
  }
};

}  // namespace

Mesh ellipsoid(const Vec3& axes, std::size_t faces, const Progress& progress) {
  ImplicitSolid solid;
  solid.function = [axes](const Vec3& point) {
    return (point.cwiseQuotient(axes).norm() - 1) * axes.minCoeff();
  };
  solid.half_width = axes.maxCoeff();
  return mesh_implicit(solid, faces, progress);
}

Mesh genus(long holes, std::size_t faces, const Progress& progress) {
  // The plate is rounded. First its outline in the plane z = 0 is shrunk by `rounding`. The solid
  // then contains all points closer than `rounding` to the shrunk plate.
  const PerforatedPlate plate(holes);
  const double rounding = 0.48 * plate.wall;
  ImplicitSolid solid;
  solid.function = [plate, rounding](const Vec3& point) {
    const double beside = std::max(plate.distance(point.head<2>()) + rounding, 0.0);
    return Vec2(beside, point.z()).norm() - rounding;
  };
  solid.genus = holes;
  return mesh_implicit(solid, faces, progress);
}

Mesh dumbbell(double neck, std::size_t faces, const Progress& progress) {
  constexpr double ball = 0.5;         // radius of each ball
  constexpr double ball_center = 0.7;  // distance from the origin along z
  const double radius = std::abs(neck);
  ImplicitSolid solid;
  solid.function = [radius](const Vec3& point) {
    const double from_axis = point.head<2>().norm();
    const double z = std::abs(point.z());
    const double from_segment = Vec2(from_axis, std::max(z - ball_center, 0.0)).norm();
    return smooth_minimum(Vec2(from_axis, z - ball_center).norm() - ball, from_segment - radius,
                          0.2);
  };
  Mesh mesh = mesh_implicit(solid, faces, progress);
  if (neck > 0) return mesh;

  // Vertices with |z| below this value are moved in x, most of all at z = 0, where x changes its
  // sign. The interval contains the middle of the neck.
  constexpr double mirrored_part = 0.4;
  for (Vec3& point : mesh.positions) {
    const double share = point.z() / mirrored_part;
    const double bump = std::max(1 - share * share, 0.0);
    point.x() *= 1 - 2 * bump * bump;
  }
  return mesh;
}

Mesh bowl(std::size_t faces, const Progress& progress) {
  constexpr double radius = 0.9;           // radius of the middle surface
  constexpr double thickness = 0.27;       // half the thickness of the shell
  constexpr double rim_angle = 0.05 * pi;  // angle of the rim above the horizontal plane
  const Vec2 rim = radius * Vec2(elementary::cos(rim_angle), elementary::sin(rim_angle));
  ImplicitSolid solid;
  solid.function = [rim](const Vec3& point) {
    const Vec2 profile(point.head<2>().norm(), point.z());
    const bool is_above = profile.y() * rim.x() > profile.x() * rim.y();
    return (is_above ? (profile - rim).norm() : std::abs(profile.norm() - radius)) - thickness;
  };
  return mesh_implicit(solid, faces, progress);
}

}  // namespace transformesh::shapes
