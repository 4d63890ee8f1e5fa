#include "shapes/noise.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "support/parallel.h"
#include "support/random.h"
#include "transformesh/measure.h"

namespace transformesh::shapes {
namespace {

// Number of steps in which vertices move along their current normals. A choice: fewer steps follow
// the changing normals less closely, more take longer.
constexpr int noise_steps = 10;
constexpr std::size_t vertices_per_noise_task = 2048;

// The twelve directions to the midpoints of a cube's edges, four of them repeated.
constexpr std::array<std::array<double, 3>, 16> gradients = {{{1, 1, 0},
                                                              {-1, 1, 0},
                                                              {1, -1, 0},
                                                              {-1, -1, 0},
                                                              {1, 0, 1},
                                                              {-1, 0, 1},
                                                              {1, 0, -1},
                                                              {-1, 0, -1},
                                                              {0, 1, 1},
                                                              {0, -1, 1},
                                                              {0, 1, -1},
                                                              {0, -1, -1},
                                                              {1, 1, 0},
                                                              {-1, 1, 0},
                                                              {0, -1, 1},
                                                              {0, -1, -1}}};

// Evaluates the random linear function of a lattice corner at an offset from this corner.
double corner_slope(const std::array<std::int64_t, 3>& cell, const Vec3& offset,
                    std::uint64_t seed) {
  std::uint64_t hash = seed;
  for (const std::int64_t coordinate : cell)
    hash = mixed(hash + 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(coordinate));
  const auto& gradient = gradients[hash % 16];
  return gradient[0] * offset.x() + gradient[1] * offset.y() + gradient[2] * offset.z();
}

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

double smooth_noise(const Vec3& point, std::uint64_t seed) {
  const Vec3 low(std::floor(point.x()), std::floor(point.y()), std::floor(point.z()));
  const Vec3 inside = point - low;
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<std::int64_t, 3> cell;
    Vec3 offset = inside;
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const int bit = corner >> axis & 1;
      cell[axis] = static_cast<std::int64_t>(low[axis]) + bit;
      offset[axis] -= bit;
      weight *= bit == 1 ? fade(inside[axis]) : 1 - fade(inside[axis]);
    }
    sum += weight * corner_slope(cell, offset, seed);
  }
  return sum;
}

void add_noise(Mesh& mesh, double amplitude, double wavelength, std::uint64_t seed,
               const Progress& progress) {
  // The noise of each vertex is computed once and moves with it.
  std::vector<double> step(mesh.positions.size());
  const std::uint64_t field = mixed(seed);
  parallel_for(step.size(), vertices_per_noise_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v)
      step[v] = amplitude / noise_steps * smooth_noise(mesh.positions[v] / wavelength, field);
  });

  for (int i = 0; i < noise_steps; ++i) {
    progress("noise", static_cast<double>(i) / noise_steps);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    for (std::size_t v = 0; v < step.size(); ++v) mesh.positions[v] += step[v] * normals[v];
  }
}

}  // namespace transformesh::shapes
