#include "transformesh/velocity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "mesh/cotangent_laplacian.h"
#include "mesh/touching_borders.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::array<const char*, 3> velocity_names{"vx", "vy", "vz"};

// Returns the names of all vertex columns as part of a message.
std::string present_names(const Mesh& mesh) {
  std::string names;
  for (const Column& column : mesh.vertex_columns.columns) {
    names += (names.empty() ? "" : ", ") + column.name;
  }
  return names.empty() ? "it has only x, y and z" : "it has " + names;
}

const Column& number_column(const Mesh& mesh, std::string_view name) {
  const Column* column = mesh.vertex_columns.find(name);
  if (column == nullptr) {
    throw InputError("the mesh has no vertex property '" + std::string(name) + "'; " +
                     present_names(mesh));
  }
  if (column->list_count_type) {
    throw InputError("the vertex property '" + std::string(name) + "' is a list, not a number");
  }
  return *column;
}

void add(const std::vector<Vec3>& more, std::vector<Vec3>& velocities) {
  for (std::size_t v = 0; v < velocities.size(); ++v) velocities[v] += more[v];
}

/// Returns the velocities in `options.given` or, if it is empty, in the columns vx, vy and vz.
/// Returns zeros if neither exists but a normal speed is specified.
std::vector<Vec3> start_of(const Mesh& mesh, const VelocityOptions& options, bool has_speed) {
  if (options.given) {
    if (options.given->size() != mesh.positions.size())
      throw UsageError(std::to_string(options.given->size()) + " velocities for " +
                       std::to_string(mesh.positions.size()) + " vertices");
    return *options.given;
  }
  if (has_column_velocities(mesh)) return column_velocities(mesh);
  if (!has_speed)
    throw InputError(ErrorKind::no_velocity,
                     "the mesh has no velocity vx vy vz at its vertices; " + present_names(mesh));
  return std::vector<Vec3>(mesh.positions.size(), Vec3::Zero());
}

}  // namespace

std::vector<Vec3> velocities_of(const Mesh& mesh, const VelocityOptions& options) {
  const bool has_speed = options.normal_speed || options.curvature_speed != 0;
  std::vector<Vec3> velocities = start_of(mesh, options, has_speed);
  if (has_speed) refuse_touching_borders(mesh);
  if (options.normal_speed) add(normal_velocities(mesh, *options.normal_speed), velocities);
  if (options.curvature_speed != 0)
    add(curvature_velocities(mesh, options.curvature_speed), velocities);
  if (!options.mask.empty()) apply_mask(mesh, options.mask, velocities);
  return velocities;
}

bool has_column_velocities(const Mesh& mesh) {
  return std::any_of(velocity_names.begin(), velocity_names.end(),
                     [&](const char* name) { return mesh.vertex_columns.find(name) != nullptr; });
}

std::vector<Vec3> column_velocities(const Mesh& mesh) {
  std::vector<Vec3> velocities(mesh.positions.size());
  for (int axis = 0; axis < 3; ++axis) {
    const Column& column = number_column(mesh, velocity_names[static_cast<std::size_t>(axis)]);
    for (std::size_t v = 0; v < velocities.size(); ++v) velocities[v][axis] = column.values[v];
  }
  return velocities;
}

std::vector<Vec3> normal_velocities(const Mesh& mesh, double speed) {
  std::vector<Vec3> velocities = vertex_normals(mesh);
  for (Vec3& velocity : velocities) velocity *= speed;
  return velocities;
}

std::vector<Vec3> curvature_velocities(const Mesh& mesh, double speed) {
  const CotangentLaplacian laplacian = cotangent_laplacian(mesh, CotangentBounds::each_edge);
  std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
  // Sums the cotangent-weighted edge vectors at each vertex.
  for (const auto& [from, to, weight] : laplacian.edges) {
    const Vec3 pull = weight * (mesh.positions[to] - mesh.positions[from]);
    sums[from] += pull;
    sums[to] -= pull;
  }

  // The length of a sum is 4 H * area, where H is the mean curvature. The sum points inwards where
  // the surface is convex.
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double area = laplacian.areas[v];
    const bool has_curvature = area > 0 && laplacian.is_border[v] == 0;
    sums[v] = has_curvature ? Vec3(speed / (4 * area) * sums[v]) : Vec3::Zero();
  }
  return sums;
}

std::vector<double> mean_curvatures(const Mesh& mesh) {
  const std::vector<Vec3> inwards = curvature_velocities(mesh, 1);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::vector<double> curvatures(inwards.size(), 0);
  for (std::size_t v = 0; v < curvatures.size(); ++v) {
    const double size = inwards[v].stableNorm();
    if (std::isfinite(size)) curvatures[v] = inwards[v].dot(normals[v]) > 0 ? -size : size;
  }
  return curvatures;
}

void apply_mask(const Mesh& mesh, std::string_view column, std::vector<Vec3>& velocities) {
  const Column& mask = number_column(mesh, column);
  for (std::size_t v = 0; v < velocities.size(); ++v) velocities[v] *= mask.values[v];
}

}  // namespace transformesh
