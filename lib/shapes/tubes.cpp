#include "shapes/tubes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes/assembly.h"
#include "support/elementary/arctangent.h"
#include "support/elementary/trigonometric.h"

namespace transformesh::shapes {
namespace {

using std::numbers::pi;
// Height of a row of triangles with unit edges.
constexpr double row_height = std::numbers::sqrt3 / 2;

/// A torus of triangle rows: `rows` (even) rows of `columns` vertices, each shifted by half a step
/// against the previous one.
struct TorusGrid {
  std::size_t columns;
  std::size_t rows;

  /// Chooses a grid of nearly equilateral triangles on a flat torus of this width (along rows) and
  /// height.
  TorusGrid(double width, double height, std::size_t faces) {
    const double step = std::sqrt(2 * width * height / (row_height * static_cast<double>(faces)));
    rows = 2 * std::max<std::size_t>(3, std::lround(height / (2 * row_height * step)));
    columns = std::max<std::size_t>(5, (faces + rows) / (2 * rows));
  }

  template <typename Surface>
  Mesh mesh(const Surface& surface) const {
    Mesh result;
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        const double shift = row % 2 == 0 ? 0.25 : 0.75;
        result.positions.push_back(
            surface((static_cast<double>(column) + shift) / static_cast<double>(columns),
                    static_cast<double>(row) / static_cast<double>(rows)));
        add_faces(result, row, column);
      }
    return result;
  }

 private:
  Index vertex(std::size_t row, std::size_t column) const {
    return static_cast<Index>((row % rows) * columns + column % columns);
  }

  // Adds the two faces on the right of an edge to the next row. Odd rows are shifted to the right.
  void add_faces(Mesh& result, std::size_t row, std::size_t column) const {
    const Index low = vertex(row, column);
    const Index low_right = vertex(row, column + 1);
    const Index high = vertex(row + 1, column);
    const Index high_right = vertex(row + 1, column + 1);
    if (row % 2 == 0) {
      result.faces.push_back({low, low_right, high});
      result.faces.push_back({low_right, high_right, high});
    } else {
      result.faces.push_back({low, low_right, high_right});
      result.faces.push_back({low, high_right, high});
    }
  }
};

/// A torus knot as a closed curve over [0, 1).
struct TorusKnot {
  double p;
  double q;
  double ring;
  // Radius of the tube that carries the knot, as a fraction of `ring`.
  static constexpr double tube_share = 0.42;

  Vec3 point(double t) const {
    const double around = 2 * pi * p * t;
    const double across = 2 * pi * q * t;
    const double radius = ring * (1 + tube_share * elementary::cos(across));
    return {radius * elementary::cos(around), radius * elementary::sin(around),
            ring * tube_share * elementary::sin(across)};
  }

  Vec3 tangent(double t) const {
    const double around = 2 * pi * p * t;
    const double across = 2 * pi * q * t;
    const double radius = 1 + tube_share * elementary::cos(across);
    const double outwards = -tube_share * q * elementary::sin(across);
    const Vec3 derivative(outwards * elementary::cos(around) - radius * p * elementary::sin(around),
                          outwards * elementary::sin(around) + radius * p * elementary::cos(around),
                          tube_share * q * elementary::cos(across));
    return derivative.normalized();
  }
};

/// Returns parameters that divide a closed curve into `count` pieces of equal length, and the
/// curve's length.
std::pair<std::vector<double>, double> equal_pieces(const TorusKnot& knot, std::size_t count) {
  const std::size_t samples = std::max<std::size_t>(4096, 8 * count);
  const auto parameter = [&](std::size_t i) {
    return static_cast<double>(i) / static_cast<double>(samples);
  };
  std::vector<double> length(samples + 1, 0);
  for (std::size_t i = 1; i <= samples; ++i)
    length[i] = length[i - 1] + (knot.point(parameter(i)) - knot.point(parameter(i - 1))).norm();

  std::vector<double> cuts(count);
  for (std::size_t k = 0, i = 0; k < count; ++k) {
    // Without the offset of 0.2137 steps, the division points would have the symmetries of the
    // knot.
    const double wanted = length.back() * (static_cast<double>(k) + 0.2137) / count;
    while (length[i + 1] < wanted) ++i;
    cuts[k] = (static_cast<double>(i) + (wanted - length[i]) / (length[i + 1] - length[i])) /
              static_cast<double>(samples);
  }
  return {std::move(cuts), length.back()};
}

/// Transports a normal of a curve from one point to the next with the least rotation (double
/// reflection). Reference: Wang, Juettler, Zheng & Liu, "Computation of rotation minimizing
/// frames", TOG 27(1), 2008.
Vec3 carried_normal(const Vec3& normal, const Vec3& from, const Vec3& from_tangent, const Vec3& to,
                    const Vec3& to_tangent) {
  const Vec3 first = to - from;
  const auto reflect = [](const Vec3& mirror, const Vec3& v) -> Vec3 {
    return v - 2 * mirror.dot(v) / mirror.squaredNorm() * mirror;
  };
  const Vec3 second = to_tangent - reflect(first, from_tangent);
  const Vec3 reflected = reflect(first, normal);
  return second.squaredNorm() == 0 ? reflected : reflect(second, reflected);
}

/// Rotates a vector about an orthogonal unit axis.
Vec3 turned(const Vec3& vector, const Vec3& axis, double angle) {
  return elementary::cos(angle) * vector + elementary::sin(angle) * axis.cross(vector);
}

/// Points along a closed curve with normals of least rotation, corrected so that the frames close.
struct FramedCurve {
  std::vector<Vec3> points, tangents, normals;

  FramedCurve(const TorusKnot& knot, const std::vector<double>& parameters) {
    for (const double t : parameters) {
      points.push_back(knot.point(t));
      tangents.push_back(knot.tangent(t));
    }
    normals.push_back(tangents[0].unitOrthogonal());
    for (std::size_t i = 1; i <= points.size(); ++i) {
      const std::size_t to = i % points.size();
      normals.push_back(
          carried_normal(normals.back(), points[i - 1], tangents[i - 1], points[to], tangents[to]));
    }
    spread_turn();
  }

 private:
  // The transported normal differs from the first one by an angle, which is distributed over all
  // points.
  void spread_turn() {
    const Vec3 binormal = tangents[0].cross(normals[0]);
    const double turn =
        elementary::atan2(normals.back().dot(binormal), normals.back().dot(normals[0]));
    normals.pop_back();
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const double angle = -turn * static_cast<double>(i) / static_cast<double>(normals.size());
      normals[i] = turned(normals[i], tangents[i], angle);
    }
  }
};

}  // namespace

Mesh torus(double ring, double tube, std::size_t faces, double phase) {
  // In conformal coordinates (u around the axis, w faster on the inner side) the metric is
  // (ring + tube cos v)^2 (du^2 + dw^2).
  const double depth = std::sqrt(ring * ring - tube * tube);
  const double stretch = std::sqrt((ring + tube) / (ring - tube));
  const TorusGrid grid(2 * pi, 2 * pi * tube / depth, faces);
  return grid.mesh([&](double along, double across) -> Vec3 {
    const double u = 2 * pi * (along + phase / static_cast<double>(grid.columns));
    const double w = pi * (across + phase / static_cast<double>(grid.rows));
    const double v = 2 * elementary::atan2(stretch * elementary::sin(w), elementary::cos(w));
    const double radius = ring + tube * elementary::cos(v);
    return {radius * elementary::cos(u), radius * elementary::sin(u), tube * elementary::sin(v)};
  });
}

Mesh tori(double gap, std::size_t faces) {
  // Width of both tori together. The center line of each torus passes through the center of the
  // other one. The lines are therefore one ring radius apart where they are closest.
  constexpr double world = 2.4;
  const double ring = (world + gap) / 4;
  const double tube = (ring - gap) / 2;
  Mesh mesh = torus(ring, tube, faces / 2, 0.137);
  Mesh other = torus(ring, tube, faces / 2, 0.618);
  const Vec3 offset(ring / 2, 0, 0);
  transform(mesh, Eigen::Matrix3d::Identity(), -offset);
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  transform(other, quarter_turn, offset);
  append(mesh, other);
  return mesh;
}

Mesh torus_knot(long p, long q, double ring, double tube, std::size_t faces) {
  const TorusKnot knot{static_cast<double>(p), static_cast<double>(q), ring};
  const double length = equal_pieces(knot, 1).second;
  const TorusGrid grid(length, 2 * pi * tube, faces);
  // Rows run along the knot. Alternate rows are shifted by half a step, which needs two sets of
  // frames.
  const FramedCurve frames(knot, equal_pieces(knot, 2 * grid.columns).first);
  return grid.mesh([&](double along, double across) -> Vec3 {
    const auto i = static_cast<std::size_t>(along * 2 * static_cast<double>(grid.columns));
    const double angle = 2 * pi * across;
    const Vec3 binormal = frames.tangents[i].cross(frames.normals[i]);
    return frames.points[i] +
           tube * (elementary::cos(angle) * frames.normals[i] - elementary::sin(angle) * binormal);
  });
}

double torus_knot_thickness(long p, long q, double ring) {
  const TorusKnot knot{static_cast<double>(p), static_cast<double>(q), ring};
  const auto samples = static_cast<std::size_t>(128 * (p + q));
  const auto parameters = equal_pieces(knot, samples).first;
  std::vector<Vec3> points;
  points.reserve(parameters.size());
  for (const double t : parameters) points.push_back(knot.point(t));

  // The thickness is the least radius of a circle that is tangent to the curve at one point and
  // passes through another.
  double thickness = ring;
  for (const double t : parameters) {
    const Vec3 here = knot.point(t);
    const Vec3 tangent = knot.tangent(t);
    for (const Vec3& point : points) {
      const Vec3 chord = point - here;
      const double from_tangent = chord.cross(tangent).norm();
      if (chord.squaredNorm() > 1e-12 * ring * ring)
        thickness = std::min(thickness, chord.squaredNorm() / (2 * from_tangent));
    }
  }
  return thickness;
}

}  // namespace transformesh::shapes
