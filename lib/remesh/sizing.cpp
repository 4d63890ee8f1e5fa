#include "remesh/sizing.h"

#include <cmath>
#include <functional>
#include <queue>

#include "remesh/curvature.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"

namespace transformesh {
namespace {

/// Sizes grow by at most this per unit of length. Larger values make fewer and less round faces.
constexpr double growth = 0.3;

double size_for(double curvature, const SizeBounds& bounds) {
  const double error = bounds.error;
  // The squared size for curvature k and error e is 6 e / k - 3 e^2. The code multiplies it by k to
  // avoid a division by zero.
  const double square_times_curvature = 6 * error - 3 * error * error * curvature;
  if (square_times_curvature <= bounds.shortest * bounds.shortest * curvature)
    return bounds.shortest;
  if (square_times_curvature >= bounds.longest * bounds.longest * curvature) return bounds.longest;
  return std::sqrt(square_times_curvature / curvature);
}

}  // namespace

std::vector<double> sizes_of_column(const Mesh& mesh, const std::string& column) {
  const Column* found = mesh.vertex_columns.find(column);
  if (!found || found->list_count_type)
    throw InputError("the mesh has no vertex property '" + column + "' with one number per vertex");
  for (std::size_t v = 0; v < found->values.size(); ++v) {
    const double size = found->values[v];
    if (std::isfinite(size) && size > 0) continue;
    throw InputError("vertex " + std::to_string(v) + " has the size " + shortest_text(size) +
                     " in property '" + column + "'; sizes must be positive lengths");
  }
  return found->values;
}

std::vector<double> sizes_of_curvature(const EditableMesh& mesh, const SizeBounds& bounds) {
  std::vector<double> sizes = largest_curvatures(mesh);
  for (double& size : sizes) size = size_for(size, bounds);
  return sizes;
}

void grade_sizes(const EditableMesh& mesh, std::vector<double>& sizes) {
  // Sizes propagate from the smallest upwards, like distances in Dijkstra's algorithm.
  struct Reached {
    double size;
    Index vertex;
    bool operator>(const Reached& other) const {
      return size != other.size ? size > other.size : vertex > other.vertex;
    }
  };
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  const auto spread = [&](Index vertex) {
    mesh.for_each_neighbor(vertex, [&](Index neighbor, Index halfedge) {
      const double most = sizes[vertex] + growth * std::sqrt(mesh.squared_length(halfedge));
      if (sizes[neighbor] <= most) return;
      sizes[neighbor] = most;
      queue.push({most, neighbor});
    });
  };
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    if (mesh.has_vertex(v)) queue.push({sizes[v], v});
  }
  while (!queue.empty()) {
    const Reached reached = queue.top();
    queue.pop();
    if (sizes[reached.vertex] == reached.size) spread(reached.vertex);
  }
}

}  // namespace transformesh
