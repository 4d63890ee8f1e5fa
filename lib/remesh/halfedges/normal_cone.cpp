#include "remesh/halfedges/normal_cone.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace transformesh {
namespace {

/// A direction is in front of a face if the cosine of its angle to the normal is above this.
constexpr float least_cosine = 0.03F;
/// Single precision represents the coordinates of normals accurately if their length is between
/// these limits.
constexpr double smallest = 1e-30;
constexpr double largest = 1e30;

/// Four numbers that one instruction processes (a vector extension of GCC and Clang).
using Floats = float __attribute__((vector_size(16)));
using Words = std::int32_t __attribute__((vector_size(16)));

/// The thirteen directions in groups of four: the axes, the diagonals of a cube's faces, and the
/// diagonals of the cube. Unused places of the last group have no bit.
struct FourDirections {
  Floats x, y, z, length;
  Words bits;
};
constexpr float face = 1.41421356F;  ///< square root of 2
constexpr float cube = 1.73205081F;  ///< square root of 3
constexpr std::array<FourDirections, 4> directions_tested{{
    {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0}, {1, 1, 1, face}, {1, 2, 4, 8}},
    {{1, 0, 0, 1}, {-1, 1, 1, 0}, {0, 1, -1, 1}, {face, face, face, face}, {16, 32, 64, 128}},
    {{-1, 1, 1, 1}, {0, 1, 1, -1}, {1, 1, -1, 1}, {face, cube, cube, cube}, {256, 512, 1024, 2048}},
    {{-1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {cube, 1, 1, 1}, {4096, 0, 0, 0}},
}};

/// Four normals, coordinate by coordinate, and the least component along a unit direction that is
/// in front of the face.
struct FourNormals {
  Floats x, y, z;
  Floats least;
};

Floats floats(NumberPair first, NumberPair second) {
  return Floats{static_cast<float>(first[0]), static_cast<float>(first[1]),
                static_cast<float>(second[0]), static_cast<float>(second[1])};
}

float needed_length(const Vec3& normal) {
  const double length = normal.norm();
  const bool is_usual = length > smallest && length < largest;
  return is_usual ? least_cosine * static_cast<float>(length) : HUGE_VALF;
}

/// Loads the first four normals. If there are fewer than four, copies of the first normal fill the
/// rest.
FourNormals four_normals(std::span<const Vec3> normals) {
  const Vec3& a = normals[0];
  const Vec3& b = normals[normals.size() > 1 ? 1 : 0];
  const Vec3& c = normals[normals.size() > 2 ? 2 : 0];
  const Vec3& d = normals[normals.size() > 3 ? 3 : 0];
  const auto coordinates = [&](Eigen::Index i) {
    return Floats{static_cast<float>(a[i]), static_cast<float>(b[i]), static_cast<float>(c[i]),
                  static_cast<float>(d[i])};
  };
  return {coordinates(0), coordinates(1), coordinates(2),
          Floats{needed_length(a), needed_length(b), needed_length(c), needed_length(d)}};
}

/// Returns the cones of four normals. Bit k is set if direction k is in front of the face, bit 16 +
/// k if the opposite direction is. Rounding to single precision is harmless, because it is far
/// smaller than the margin of least_cosine.
Words cones_of_four(const FourNormals& n) {
  Words front{};
  Words back{};
  std::int32_t bit = 1;
  const auto look = [&](const Floats& along, const Floats& needed) {
    front |= (along > needed) & bit;
    back |= (along < -needed) & bit;
    bit *= 2;
  };
  look(n.x, n.least);
  look(n.y, n.least);
  look(n.z, n.least);
  const Floats sum = n.x + n.y;
  const Floats difference = n.x - n.y;
  const Floats in_face = face * n.least;
  look(sum, in_face);
  look(difference, in_face);
  look(n.y + n.z, in_face);
  look(n.y - n.z, in_face);
  look(n.x + n.z, in_face);
  look(n.z - n.x, in_face);
  const Floats in_cube = cube * n.least;
  look(sum + n.z, in_cube);
  look(sum - n.z, in_cube);
  look(difference + n.z, in_cube);
  look(n.z - difference, in_cube);
  return front | back << 16;
}

/// Computes needed_length() of four normals from their squared lengths.
Floats needed_lengths(NumberPair first_squares, NumberPair second_squares) {
  const NumberPair first = square_roots(first_squares);
  const NumberPair second = square_roots(second_squares);
  const MaskPair are_usual = (first > twice(smallest)) & (first < twice(largest)) &
                             (second > twice(smallest)) & (second < twice(largest));
  Floats lengths = floats(first, second);
  if (!all(are_usual))
    for (int i = 0; i < 4; ++i) {
      const double length = i < 2 ? first[i] : second[i - 2];
      if (!(length > smallest && length < largest)) lengths[i] = HUGE_VALF;
    }
  return least_cosine * lengths;
}

NormalCone common_bits(const Words& cone) {
  return all_directions & static_cast<NormalCone>(cone[0] & cone[1] & cone[2] & cone[3]);
}

}  // namespace

NormalCone common_cone(std::span<const Vec3> normals) {
  Words cone{-1, -1, -1, -1};
  for (std::size_t i = 0; i < normals.size(); i += 4)
    cone &= cones_of_four(four_normals(normals.subspan(i)));
  return common_bits(cone);
}

// If the last group has fewer than four normals, copies of normals of the group or of the first one
// fill it.
NormalCone common_cone(std::span<const NormalPair> pairs, std::size_t count) {
  Words cone{-1, -1, -1, -1};
  const auto pair_at = [&](std::size_t i) {
    if (i >= count) i = 0;
    NormalPair pair = pairs[i / 2];
    if (i + 1 == count)
      for (NumberPair* numbers : {&pair.normal.x, &pair.normal.y, &pair.normal.z, &pair.squared})
        (*numbers)[1] = (*numbers)[0];
    return pair;
  };
  for (std::size_t i = 0; i < count; i += 4) {
    const NormalPair first = pair_at(i);
    const NormalPair second = pair_at(i + 2);
    cone &= cones_of_four(
        {floats(first.normal.x, second.normal.x), floats(first.normal.y, second.normal.y),
         floats(first.normal.z, second.normal.z), needed_lengths(first.squared, second.squared)});
  }
  return common_bits(cone);
}

void find_cones(std::span<const Vec3> normals, std::span<NormalCone> cones) {
  for (std::size_t i = 0; i < normals.size(); i += 4) {
    const Words four = cones_of_four(four_normals(normals.subspan(i)));
    for (std::size_t k = 0; k < std::min<std::size_t>(4, normals.size() - i); ++k)
      cones[i + k] = static_cast<NormalCone>(four[k]);
  }
}

Direction nearest_direction(NormalCone cone, const Vec3& vector) {
  const Eigen::Vector3f unit = vector.stableNormalized().cast<float>();
  Direction nearest;
  float best = -HUGE_VALF;
  for (const FourDirections& four : directions_tested) {
    const Floats along = (four.x * unit.x() + four.y * unit.y() + four.z * unit.z()) / four.length;
    for (int i = 0; i < 4; ++i) {
      const auto front = static_cast<NormalCone>(four.bits[i]);
      for (const float sign : {1.0F, -1.0F}) {
        const NormalCone bit = sign > 0 ? front : front << 16;
        if ((cone & bit) == 0 || !(sign * along[i] > best)) continue;
        best = sign * along[i];
        nearest = {bit, sign * Vec3(four.x[i], four.y[i], four.z[i]) / four.length[i]};
      }
    }
  }
  return nearest;
}

bool sees(const Vec3& direction, const Triangle& triangle) {
  const Vec3 normal = reliable_normal(triangle[0], triangle[1], triangle[2]);
  const double along = direction.dot(normal);
  return along > 0 && along * along > least_cosine * least_cosine * normal.squaredNorm();
}

}  // namespace transformesh
