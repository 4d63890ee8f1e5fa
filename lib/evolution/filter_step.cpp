#include "evolution/filter_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/counted.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"
#include "transformesh/velocity.h"

namespace transformesh {
namespace {

constexpr std::array<const char*, 3> velocity_names{"vx", "vy", "vz"};

std::string bytes_of(const Mesh& mesh, Scalar coordinate) {
  Document document;
  document.mesh = mesh;
  document.style.coordinate = coordinate;
  return write_mesh(document).bytes;
}

void check_same_elements(const Mesh& before, const Mesh& after) {
  const std::string reason =
      "; a step may only move vertices, because the loop cleans and remeshes";
  if (before.positions.size() != after.positions.size()) {
    throw InputError("the step returned " + counted(after.positions.size(), "vertex") +
                     " instead of " + std::to_string(before.positions.size()) + reason);
  }
  if (before.faces != after.faces) throw InputError("the step changed faces" + reason);
}

DisplaceResult movement(const Mesh& before, const Mesh& after) {
  DisplaceResult result;
  double squares = 0;
  for (std::size_t v = 0; v < before.positions.size(); ++v) {
    const double way = (after.positions[v] - before.positions[v]).norm();
    result.moved += way > 0 ? 1 : 0;
    result.max_displacement = std::max(result.max_displacement, way);
    squares += way * way;
  }
  result.rms_displacement = std::sqrt(squares / static_cast<double>(before.positions.size()));
  result.mean_edge = edge_lengths(before).mean;
  return result;
}

// Removes the velocity columns (vx, vy, vz) that the filter added to the mesh.
void drop_velocities(const Mesh& before, Mesh& after) {
  for (const char* name : velocity_names)
    if (before.vertex_columns.find(name) == nullptr) after.vertex_columns.erase(name);
}

}  // namespace

Step step_through(MeshFilter filter, Scalar coordinate, const DisplaceOptions& options) {
  return [filter = std::move(filter), coordinate, options](Mesh& mesh, const Progress& progress) {
    progress("step");
    const std::string bytes = filter(bytes_of(mesh, coordinate));
    Mesh after = read_mesh(bytes, "the step's output", {.strict = true}).document.mesh;
    check_same_elements(mesh, after);
    DisplaceResult result = movement(mesh, after);
    if (result.moved == 0 && has_column_velocities(after))
      result = displace(after, column_velocities(after), options);
    drop_velocities(mesh, after);
    mesh = std::move(after);
    return result;
  };
}

std::string bytes_for_filter(const Mesh& mesh) { return bytes_of(mesh, Scalar::float64); }

std::vector<Vec3> velocities_in(const std::string& bytes) {
  return column_velocities(
      read_mesh(bytes, "the output of the velocity command", {.strict = true}).document.mesh);
}

}  // namespace transformesh
