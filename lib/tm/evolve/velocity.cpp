#include "tm/evolve/velocity.h"

#include <array>
#include <string>

#include "tm/mesh/measure.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr std::array<const char*, 3> velocity_names{"vx", "vy", "vz"};

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

}  // namespace

bool has_column_velocities(const Mesh& mesh) {
  for (const char* name : velocity_names) {
    if (mesh.vertex_columns.find(name) == nullptr) return false;
  }
  return true;
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

void apply_mask(const Mesh& mesh, std::string_view name, std::vector<Vec3>& velocities) {
  const Column& mask = number_column(mesh, name);
  for (std::size_t v = 0; v < velocities.size(); ++v) velocities[v] *= mask.values[v];
}

}  // namespace transformesh
