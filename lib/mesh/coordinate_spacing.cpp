#include "mesh/coordinate_spacing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "transformesh/errors.h"

namespace transformesh {
namespace {

// Cosine of 45 degrees. The normal of a face counts as turned (RoundingLoss::turned) if it rotates
// by a larger angle.
constexpr double least_cosine = 0.7071067811865476;
constexpr int float_digits_fewer =
    std::numeric_limits<double>::digits - std::numeric_limits<float>::digits;

bool has_collapsed(std::span<const Vec3> positions, const Face& face) {
  const Vec3& a = positions[face[0]];
  const Vec3& b = positions[face[1]];
  const Vec3& c = positions[face[2]];
  return a == b || b == c || c == a;
}

/// Returns the unit normal, without overflow or underflow; zero if the face has no area.
Vec3 direction(std::span<const Vec3> positions, const Face& face) {
  const Vec3& a = positions[face[0]];
  const Vec3 ab = (positions[face[1]] - a).stableNormalized();
  const Vec3 ac = (positions[face[2]] - a).stableNormalized();
  return ab.cross(ac).stableNormalized();
}

}  // namespace

double spacing_at(double coordinate, Scalar type) {
  const double size = std::abs(coordinate);
  const double spacing = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) + 1) - size;
  return type == Scalar::float32 ? spacing * (1U << float_digits_fewer) : spacing;
}

double spacing_around(const Vec3& point, Scalar type) {
  const double least = type == Scalar::float32 ? std::numeric_limits<float>::denorm_min()
                                               : std::numeric_limits<double>::denorm_min();
  return std::max(spacing_at(point.cwiseAbs().maxCoeff(), type), least);
}

double coordinate_spacing(const Mesh& mesh, Scalar type) {
  double largest = 0;
  for (const Vec3& position : mesh.positions)
    largest = std::max(largest, position.cwiseAbs().maxCoeff());
  return spacing_at(largest, type);
}

RoundingLoss rounding_loss(const Mesh& mesh, std::span<const Vec3> before) {
  RoundingLoss loss;
  for (const Face& face : mesh.faces) {
    if (has_collapsed(before, face)) continue;
    if (has_collapsed(mesh.positions, face)) {
      ++loss.collapsed;
      continue;
    }
    const Vec3 normal = direction(before, face);
    if (!normal.isZero(0) && normal.dot(direction(mesh.positions, face)) < least_cosine)
      ++loss.turned;
  }
  return loss;
}

void check_float_range(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const bool fits = mesh.positions[i].cast<float>().allFinite();
    if (fits) continue;
    throw GoalError("vertex " + std::to_string(i) +
                    " has a coordinate too large for float: write double");
  }
}

std::size_t round_positions(Mesh& mesh, Scalar coordinate) {
  if (coordinate != Scalar::float32) return 0;
  check_float_range(mesh);
  const std::vector<Vec3> before = mesh.positions;
  for (Vec3& position : mesh.positions) position = rounded_to(position, coordinate);
  const RoundingLoss loss = rounding_loss(mesh, before);
  if (2 * (loss.collapsed + loss.turned) > mesh.faces.size()) {
    throw GoalError(
        "float is too coarse for this mesh: most of its faces would collapse or turn over; write "
        "double, in PLY, OFF or OBJ, or move the mesh to the origin first");
  }
  return loss.collapsed;
}

std::optional<Mesh> rounded_mesh(const Mesh& mesh, Scalar coordinate) {
  const auto is_stored = [&](const Vec3& position) {
    return !position.allFinite() || rounded_to(position, coordinate) == position;
  };
  if (coordinate != Scalar::float32 || std::ranges::all_of(mesh.positions, is_stored)) return {};
  Mesh rounded = mesh;
  round_positions(rounded, coordinate);
  return rounded;
}

}  // namespace transformesh
