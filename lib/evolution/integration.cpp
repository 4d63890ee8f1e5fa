#include "evolution/integration.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mesh/location_text.h"
#include "mesh/surface_columns.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

void check(const Mesh& mesh, const std::vector<Vec3>& vectors) {
  if (vectors.size() != mesh.positions.size()) {
    throw InputError("the motion returned " + counted(vectors.size(), "vector") + " for " +
                     counted(mesh.positions.size(), "vertex"));
  }
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    if (vectors[v].allFinite()) continue;
    throw InputError("the velocity of " + vertex_text(mesh, static_cast<Index>(v)) +
                     " is not a finite number");
  }
}

std::vector<Vec3> scaled(const std::vector<Vec3>& vectors, double factor) {
  std::vector<Vec3> result(vectors.size());
  for (std::size_t v = 0; v < vectors.size(); ++v) result[v] = factor * vectors[v];
  return result;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - b[v]).norm());
  return largest;
}

}  // namespace

Integration::Integration(const Motion& motion, const Mesh& mesh, double time, Integrator integrator,
                         const Progress& progress)
    : motion_(motion), mesh_(mesh), time_(time), integrator_(integrator), progress_(progress) {
  if (motion.displacement) return;
  first_ = motion.velocity(mesh, {time, 0, 0}, progress);
  check(mesh, first_);
}

std::vector<Vec3> Integration::velocities_at(double delay, const std::vector<Vec3>& offsets,
                                             double span, int stage) const {
  Mesh moved = mesh_;
  for (std::size_t v = 0; v < offsets.size(); ++v) moved.positions[v] += offsets[v];
  refresh_normals(moved);
  std::vector<Vec3> velocities = motion_.velocity(moved, {time_ + delay, span, stage}, progress_);
  check(moved, velocities);
  return velocities;
}

Integrated Integration::midpoint(double span) const {
  const double half = span / 2;
  Integrated result{scaled(velocities_at(half, scaled(first_, half), span, 1), span)};
  result.error = largest_difference(result.displacements, scaled(first_, span));
  return result;
}

Integrated Integration::rk4(double span) const {
  const double half = span / 2;
  const std::vector<Vec3> second = velocities_at(half, scaled(first_, half), span, 1);
  const std::vector<Vec3> third = velocities_at(half, scaled(second, half), span, 2);
  const std::vector<Vec3> fourth = velocities_at(span, scaled(third, span), span, 3);
  Integrated result{std::vector<Vec3>(first_.size())};
  for (std::size_t v = 0; v < first_.size(); ++v)
    result.displacements[v] = span / 6 * (first_[v] + 2 * second[v] + 2 * third[v] + fourth[v]);
  result.error = largest_difference(result.displacements, scaled(second, span));
  return result;
}

Integrated Integration::over(double span) const {
  if (motion_.displacement) {
    Integrated result{motion_.displacement(mesh_, {time_, span, 0}, progress_)};
    check(mesh_, result.displacements);
    return result;
  }
  if (integrator_ == Integrator::midpoint) return midpoint(span);
  if (integrator_ == Integrator::rk4) return rk4(span);
  return {scaled(first_, span)};
}

int error_order(Integrator integrator) { return integrator == Integrator::rk4 ? 3 : 2; }

DisplaceResult move_vertices(Mesh& mesh, const std::vector<Vec3>& displacements, double mean_edge) {
  DisplaceResult result;
  result.mean_edge = mean_edge;
  double squares = 0;
  for (std::size_t v = 0; v < displacements.size(); ++v) {
    const double length = displacements[v].norm();
    mesh.positions[v] += displacements[v];
    result.moved += length > 0 ? 1 : 0;
    result.max_displacement = std::max(result.max_displacement, length);
    squares += length * length;
  }
  if (!displacements.empty())
    result.rms_displacement = std::sqrt(squares / static_cast<double>(displacements.size()));
  if (result.moved > 0) result.new_normals = refresh_normals(mesh);
  return result;
}

}  // namespace transformesh
