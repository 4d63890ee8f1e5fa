#include "transformesh/velocity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "mesh/edges.h"
#include "mesh/touching_borders.h"
#include "mesh/triangle.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::array<const char*, 3> velocity_names{"vx", "vy", "vz"};

/// The cotangent of the angle across from the halfedge, in its face.
double opposite_cotangent(const Mesh& mesh, Index halfedge) {
  const Vec3& apex = mesh.positions[halfedge_source(mesh, previous_halfedge(halfedge))];
  return clamped_cotangent(mesh.positions[halfedge_source(mesh, halfedge)] - apex,
                           mesh.positions[halfedge_target(mesh, halfedge)] - apex);
}

/// How much of a face belongs to each corner: the part nearest to it, or, where the face is obtuse,
/// half of it to the obtuse corner and a quarter to each other.
Vec3 corner_areas(const Mesh& mesh, Index face) {
  Vec3 squares;     // of the lengths of the edges from corner i
  Vec3 cotangents;  // of the angles across from them
  for (int i = 0; i < 3; ++i) {
    const Index halfedge = 3 * face + static_cast<Index>(i);
    squares[i] = (mesh.positions[halfedge_target(mesh, halfedge)] -
                  mesh.positions[halfedge_source(mesh, halfedge)])
                     .squaredNorm();
    cotangents[i] = opposite_cotangent(mesh, halfedge);
  }
  Vec3 shares;
  const double area = face_area(mesh, face);
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3;
    const bool is_obtuse_here = cotangents[(i + 1) % 3] < 0;
    shares[i] = cotangents.minCoeff() < 0
                    ? area / (is_obtuse_here ? 2 : 4)
                    : (squares[i] * cotangents[i] + squares[before] * cotangents[before]) / 8;
  }
  return shares;
}

// The names of all vertex columns, for a message.
std::string present_names(const Mesh& mesh) {
  std::string names;
  for (const Column& column : mesh.vertex_columns.columns) {
    names += (names.empty() ? "" : ", ") + column.name;
  }
  return names.empty() ? "it has none but x y z" : "it has " + names;
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

/// The velocities that do not follow from a speed.
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
  return std::all_of(velocity_names.begin(), velocity_names.end(),
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
  std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
  std::vector<double> areas(mesh.positions.size(), 0);
  std::vector<bool> is_border(mesh.positions.size(), false);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 shares = corner_areas(mesh, static_cast<Index>(f));
    for (int i = 0; i < 3; ++i) areas[mesh.faces[f][i]] += shares[i];
  }

  // Every edge pulls its ends together.
  const Edges edges(mesh);
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto halfedges = edges.halfedges(edge);
    const Index from = halfedge_source(mesh, halfedges[0]);
    const Index to = halfedge_target(mesh, halfedges[0]);
    if (halfedges.size() == 1) is_border[from] = is_border[to] = true;
    double weight = 0;
    for (const Index halfedge : halfedges) weight += opposite_cotangent(mesh, halfedge);
    const Vec3 pull = std::max(weight, 0.0) * (mesh.positions[to] - mesh.positions[from]);
    sums[from] += pull;
    sums[to] -= pull;
  }

  // The sum is 4 H times the area, and points inwards where the surface is convex.
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const bool has_curvature = areas[v] > 0 && !is_border[v];
    sums[v] = has_curvature ? Vec3(speed / (4 * areas[v]) * sums[v]) : Vec3::Zero();
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
