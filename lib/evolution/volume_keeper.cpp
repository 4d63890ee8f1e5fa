#include "evolution/volume_keeper.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "io/document/round_as_written.h"
#include "mesh/disjoint_sets.h"
#include "mesh/local_measures.h"
#include "mesh/surface_columns.h"
#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

const std::string movement_name = "tm_movement", component_name = "tm_component";

/// Largest movement by which the volume is restored, as a fraction of the mean edge. Less is enough
/// after remeshing and cleaning in one step. A change of topology needs more; then a movement along
/// normals would spread its volume over the surface.
constexpr double largest_motion = 0.1;

/// Returns three times the gradient of the volume with respect to each position: the sum of the
/// area normals of the vertex's faces.
std::vector<Vec3> volume_gradients(const Mesh& mesh) {
  std::vector<Vec3> gradients(mesh.positions.size(), Vec3::Zero());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Vec3 normal = face_normal(mesh, static_cast<Index>(f)) / 2;
    for (const Index v : mesh.faces[f]) gradients[v] += normal;
  }
  return gradients;
}

/// Removes a column and returns its values; 0 for all rows if there is no such column.
std::vector<double> taken(Columns& columns, const std::string& name, std::size_t rows) {
  std::vector<double> values;
  if (const Column* column = columns.find(name)) {
    values.assign(column->values.begin(), column->values.end());
    columns.erase(name);
  }
  values.resize(rows, 0);
  return values;
}

/// A part of a mesh. `vertices` maps each vertex of the part to the vertex of the whole mesh.
struct Part {
  Mesh mesh;
  std::vector<Index> vertices;
};

/// `of_face` is the part of each face; parts share no vertices.
std::vector<Part> parts_of(const Mesh& mesh, const std::vector<Index>& of_face) {
  std::vector<Part> parts;
  std::vector<Index> numbers(mesh.positions.size(), no_index);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (of_face[f] >= parts.size()) parts.resize(of_face[f] + 1);
    Part& part = parts[of_face[f]];
    Face face = mesh.faces[f];
    for (Index& v : face) {
      if (numbers[v] == no_index) {
        numbers[v] = static_cast<Index>(part.vertices.size());
        part.vertices.push_back(v);
        part.mesh.positions.push_back(mesh.positions[v]);
      }
      v = numbers[v];
    }
    part.mesh.faces.push_back(face);
  }
  return parts;
}

/// Sets of components before and after a change that have faces in common. If a set has components
/// from before the change, its number is that of the first one.
struct Joined {
  std::vector<Index> of_face;   ///< set of each face after the change
  std::vector<double> volumes;  ///< volume of each set before the change
};

/// `numbers` is 1 + the component before the change of each face; 0 if unknown. `volumes` are those
/// of the components before the change.
Joined joined_components(const Mesh& mesh, const std::vector<double>& numbers,
                         const std::vector<double>& volumes) {
  const Components now = connected_components(mesh);
  const auto before = static_cast<Index>(volumes.size());
  DisjointSets sets(before + now.components.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (numbers[f] > 0) sets.join(static_cast<Index>(numbers[f]) - 1, before + now.of_face[f]);
  Joined joined{{}, std::vector<double>(before, 0)};
  for (const Index component : now.of_face) joined.of_face.push_back(sets.find(before + component));
  for (Index i = 0; i < before; ++i) joined.volumes[sets.find(i)] += volumes[i];
  return joined;
}

}  // namespace

bool move_to_volume(Mesh& mesh, double volume, const std::vector<double>& weights, double limit) {
  std::vector<Vec3> directions = volume_gradients(mesh);
  for (std::size_t v = 0; v < directions.size(); ++v) {
    const double size = directions[v].norm();
    directions[v] = size > 0 ? Vec3(weights[v] / size * directions[v]) : Vec3::Zero();
  }
  const std::vector<Vec3> start = mesh.positions;
  double distance = 0;
  // Apply Newton's method to the volume, a cubic polynomial of `distance` that is nearly linear.
  // Two steps suffice for small distances; the third removes rounding errors.
  for (int round = 0; round < 3; ++round) {
    const std::vector<Vec3> gradients = volume_gradients(mesh);
    double slope = 0;
    for (std::size_t v = 0; v < start.size(); ++v) slope += directions[v].dot(gradients[v]) / 3;
    distance += (volume - transformesh::volume(mesh)) / slope;
    if (!(std::abs(distance) <= limit)) {
      mesh.positions = start;
      return false;
    }
    for (std::size_t v = 0; v < start.size(); ++v)
      mesh.positions[v] = start[v] + distance * directions[v];
  }
  return true;
}

namespace {

/// Moves a part to a volume, in proportion to the movements of its vertices, or all of its vertices
/// alike if none has moved. If only few have moved, these would have to move too far; then all
/// vertices that have moved are moved alike.
bool restore_part(Part& part, const std::vector<double>& movements, double volume, double limit) {
  double largest = 0;
  for (const Index v : part.vertices) largest = std::max(largest, movements[v]);
  std::vector<double> weights, equal;
  for (const Index v : part.vertices) {
    weights.push_back(largest > 0 ? movements[v] / largest : 1);
    equal.push_back(weights.back() > 0 ? 1 : 0);
  }
  return move_to_volume(part.mesh, volume, weights, limit) ||
         move_to_volume(part.mesh, volume, equal, limit);
}

}  // namespace

void VolumeKeeper::begin(Mesh& mesh, const std::vector<Vec3>& displacements) {
  Column& column = mesh.vertex_columns.get(movement_name, Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < displacements.size(); ++v) column.values[v] = displacements[v].norm();
  const Components found = connected_components(mesh);
  Column& numbers = mesh.face_columns.get(component_name, Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    numbers.values[f] = 1.0 + static_cast<double>(found.of_face[f]);
  volumes_.clear();
  for (const Part& part : parts_of(mesh, found.of_face))
    volumes_.push_back(transformesh::volume(part.mesh));
}

bool VolumeKeeper::restore(Document& document) const {
  Mesh& mesh = document.mesh;
  const std::vector<double> movements =
      taken(mesh.vertex_columns, movement_name, mesh.positions.size());
  const std::vector<double> numbers = taken(mesh.face_columns, component_name, mesh.faces.size());
  if (mesh.faces.empty()) return false;

  const Joined joined = joined_components(mesh, numbers, volumes_);
  const double limit = largest_motion * halfedge_lengths(mesh).mean;
  bool has_moved = false;
  std::vector<Part> parts = parts_of(mesh, joined.of_face);
  for (std::size_t i = 0; i < std::min(parts.size(), volumes_.size()); ++i) {
    Part& part = parts[i];
    // Equal volumes are left alone, so that rounding does not move components at rest.
    if (part.mesh.faces.empty() || transformesh::volume(part.mesh) == joined.volumes[i]) continue;
    if (!restore_part(part, movements, joined.volumes[i], limit)) continue;
    for (std::size_t v = 0; v < part.vertices.size(); ++v)
      mesh.positions[part.vertices[v]] = part.mesh.positions[v];
    has_moved = true;
  }
  if (!has_moved) return false;
  refresh_normals(mesh);
  round_as_written(document);
  return true;
}

double VolumeKeeper::volume() const {
  return std::accumulate(volumes_.begin(), volumes_.end(), 0.0);
}

}  // namespace transformesh
