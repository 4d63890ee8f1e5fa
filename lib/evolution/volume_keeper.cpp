#include "evolution/volume_keeper.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/document/round_as_written.h"
#include "mesh/local_measures.h"
#include "mesh/surface_columns.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

const std::string column_name = "tm_movement";

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

/// Removes the column with the lengths of movements, and returns it divided by its maximum. Returns
/// 1 for all vertices if the maximum is 0.
std::vector<double> taken_weights(Mesh& mesh) {
  std::vector<double> weights;
  if (const Column* column = mesh.vertex_columns.find(column_name)) {
    weights.assign(column->values.begin(), column->values.end());
    mesh.vertex_columns.erase(column_name);
  }
  weights.resize(mesh.positions.size(), 0);
  double largest = 0;
  for (const double weight : weights) largest = std::max(largest, weight);
  for (double& weight : weights) weight = largest > 0 ? weight / largest : 1;
  return weights;
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

void VolumeKeeper::begin(Mesh& mesh, const std::vector<Vec3>& displacements) {
  volume_ = transformesh::volume(mesh);
  Column& column = mesh.vertex_columns.get(column_name, Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < displacements.size(); ++v) column.values[v] = displacements[v].norm();
}

bool VolumeKeeper::restore(Document& document) const {
  Mesh& mesh = document.mesh;
  const std::vector<double> weights = taken_weights(mesh);
  if (mesh.faces.empty()) return false;
  const double limit = largest_motion * halfedge_lengths(mesh).mean;
  if (!move_to_volume(mesh, volume_, weights, limit)) return false;
  refresh_normals(mesh);
  round_as_written(document);
  return true;
}

}  // namespace transformesh
