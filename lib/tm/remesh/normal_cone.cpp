#include "tm/remesh/normal_cone.h"

#include <Eigen/Geometry>
#include <array>

namespace transformesh {
namespace {

/// A direction sees a front when its cosine to the normal is above this.
constexpr float least_cosine = 0.03F;
/// Of normals between these lengths single precision holds the coordinates well.
constexpr double smallest = 1e-30;
constexpr double largest = 1e30;

/// Four numbers that the processor treats at once (an extension that GCC and Clang share).
using Floats = float __attribute__((vector_size(16)));
using Words = std::int32_t __attribute__((vector_size(16)));

/// Thirteen directions in fours, padded with none: the axes, the diagonals of a cube's faces, and
/// its diagonals.
struct FourDirections {
  Floats x, y, z, length;
  Words bits;
};
constexpr float face = 1.41421356F;
constexpr float cube = 1.73205081F;
constexpr std::array<FourDirections, 4> directions_tested{{
    {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0}, {1, 1, 1, face}, {1, 2, 4, 8}},
    {{1, 0, 0, 1}, {-1, 1, 1, 0}, {0, 1, -1, 1}, {face, face, face, face}, {16, 32, 64, 128}},
    {{-1, 1, 1, 1}, {0, 1, 1, -1}, {1, 1, -1, 1}, {face, cube, cube, cube}, {256, 512, 1024, 2048}},
    {{-1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {cube, 1, 1, 1}, {4096, 0, 0, 0}},
}};

}  // namespace

/// Bit k is set where direction k sees the front, bit 16 + k where the opposite direction does.
/// Single precision is far finer than the margin of least_cosine.
NormalCone cone_of(const Vec3& normal) {
  const double length = normal.norm();
  if (!(length > smallest && length < largest)) return 0;
  const auto x = static_cast<float>(normal.x());
  const auto y = static_cast<float>(normal.y());
  const auto z = static_cast<float>(normal.z());
  const float least = least_cosine * static_cast<float>(length);
  Words front{};
  Words back{};
  for (const FourDirections& four : directions_tested) {
    const Floats along = four.x * x + four.y * y + four.z * z;
    const Floats needed = four.length * least;
    front |= (along > needed) & four.bits;
    back |= (along < -needed) & four.bits;
  }
  const Words both = front | back << 16;
  return static_cast<NormalCone>(both[0] | both[1] | both[2] | both[3]);
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
  const Vec3 normal = normal_of(triangle[0], triangle[1], triangle[2]);
  const double along = direction.dot(normal);
  return along > 0 && along * along > least_cosine * least_cosine * normal.squaredNorm();
}

}  // namespace transformesh
