#include "flow/flow_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/location_text.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

FlowSpeeds speeds_of(const std::vector<Vec3>& velocities) {
  FlowSpeeds speeds;
  for (const Vec3& velocity : velocities)
    speeds.maximum = std::max(speeds.maximum, velocity.stableNorm());
  if (speeds.maximum == 0) return speeds;
  // Divide speeds by the largest one, so that no square overflows.
  double squares = 0;
  for (const Vec3& velocity : velocities) squares += (velocity / speeds.maximum).squaredNorm();
  speeds.rms = speeds.maximum * std::sqrt(squares / static_cast<double>(velocities.size()));
  return speeds;
}

}  // namespace

FlowSpeeds add_flow_columns(Mesh& mesh, const Motion& motion, const Moment& moment,
                            const Progress& progress) {
  progress("flow");
  const bool has_step = moment.span > 0 && motion.displacement;
  std::vector<Vec3> velocities =
      (has_step ? motion.displacement : motion.velocity)(mesh, moment, progress);
  for (std::size_t v = 0; v < velocities.size(); ++v) {
    if (has_step) velocities[v] /= moment.span;
    if (!velocities[v].allFinite())
      throw InputError("the velocity of " + vertex_text(mesh, static_cast<Index>(v)) +
                       " is not a finite number");
  }
  constexpr std::array<const char*, 3> names{"vx", "vy", "vz"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Column& column = mesh.vertex_columns.get(names[axis], Scalar::float64, velocities.size());
    for (std::size_t v = 0; v < velocities.size(); ++v)
      column.values[v] = velocities[v][static_cast<Eigen::Index>(axis)];
  }
  return speeds_of(velocities);
}

}  // namespace transformesh
