#include "transformesh/target.h"

#include <array>
#include <cmath>
#include <string>

#include "geometry/search/closest_point.h"
#include "mesh/local_measures.h"
#include "mesh/touching_borders.h"
#include "step/estimate_normals.h"
#include "step/prepare_target.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/stitch.h"

namespace transformesh {
namespace {

constexpr std::array<const char*, 3> normal_names{"nx", "ny", "nz"};

void refuse_inside_out(const Mesh& mesh) {
  if (volume(mesh) < 0 && check_manifold(mesh).is_closed()) {
    throw InputError(ErrorKind::inside_out, "the target is inside out");
  }
}

std::vector<Vec3> column_normals(const Mesh& mesh, const std::array<const Column*, 3>& columns) {
  std::vector<Vec3> normals(mesh.positions.size());
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3 normal(columns[0]->values[v], columns[1]->values[v], columns[2]->values[v]);
    if (!normal.allFinite()) {
      throw InputError("the normal of point " + std::to_string(v) + " is not finite");
    }
    // Do not normalize a unit normal again, because rounding could change it. Normals thus stay the
    // same if a target is written to a file and read again.
    const bool is_unit = std::abs(normal.squaredNorm() - 1) < 1e-15;
    normals[v] = is_unit ? normal : normal.stableNormalized();
  }
  return normals;
}

void add_point_normals(Target& target) {
  target.normals = stored_normals(target.mesh);
  target.has_estimated_normals = target.normals.empty();
  if (target.normals.empty()) target.normals = estimate_normals(target.mesh.positions);
}

}  // namespace

Target make_target(Mesh mesh) {
  if (mesh.positions.empty()) throw InputError("the target has no points");
  Target target;
  target.mesh = std::move(mesh);
  if (!target.is_mesh()) {
    add_point_normals(target);
    return target;
  }
  if (used_positions(target.mesh).size() < target.mesh.positions.size()) {
    target.mesh = select_faces(target.mesh, std::vector<bool>(target.mesh.faces.size(), true));
  }
  // All faces at an edge or a vertex determine the sign of the distance there, and must therefore
  // share vertices. Inconsistently oriented faces are not stitched; check_target() refuses them.
  if (count_touching_borders(target.mesh) > 0) stitch(target.mesh);
  refuse_inside_out(target.mesh);
  return target;
}

void order_spatially(Target& target) {
  if (!target.is_mesh() || target.has_spatial_order) return;
  std::vector<Face> faces;
  faces.reserve(target.mesh.faces.size());
  for (const Index face : spatial_face_order(target.mesh)) faces.push_back(target.mesh.faces[face]);
  target.mesh.faces = std::move(faces);
  target.mesh.face_columns = {};
  target.has_spatial_order = true;
}

std::vector<Vec3> stored_normals(const Mesh& mesh) {
  std::array<const Column*, 3> columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    columns[axis] = mesh.vertex_columns.find(normal_names[axis]);
    if (columns[axis] == nullptr || columns[axis]->list_count_type) return {};
  }
  return column_normals(mesh, columns);
}

void set_normal_columns(Mesh& mesh, const std::vector<Vec3>& normals) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Column& column = mesh.vertex_columns.get(normal_names[axis], Scalar::float64, normals.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
      column.values[v] = normals[v][static_cast<Eigen::Index>(axis)];
    }
  }
}

}  // namespace transformesh
