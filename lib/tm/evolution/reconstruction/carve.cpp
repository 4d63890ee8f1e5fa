#include "tm/evolution/reconstruction/carve.h"

#include <algorithm>

#include "tm/mesh/measure.h"
#include "tm/views/photo/thin_plate.h"

namespace transformesh {
namespace {

constexpr double doubtful = 0.2;
constexpr int rounds = 5;  ///< of smoothing
/// Share of doubtful neighbors at which a vertex stays, and beyond which it moves all the way.
constexpr double least_share = 0.3, full_share = 0.7;

/// Goes half of the way to the mean of the neighbors, again and again.
void smooth(const Umbrella& umbrella, std::vector<Vec3>& values) {
  std::vector<Vec3> ways;
  for (int round = 0; round < rounds; ++round) {
    umbrella.apply(values, ways);
    for (std::size_t v = 0; v < values.size(); ++v) values[v] += 0.5 * ways[v];
  }
}

}  // namespace

double carve(Mesh& mesh, const std::vector<double>& doubt, double depth) {
  const Umbrella umbrella(mesh);
  std::vector<Vec3> shares(doubt.size(), Vec3::Zero());
  for (std::size_t v = 0; v < doubt.size(); ++v)
    if (doubt[v] > doubtful && doubt[v] < 1) shares[v].x() = 1;
  smooth(umbrella, shares);
  std::vector<Vec3> normals = vertex_normals(mesh);
  smooth(umbrella, normals);

  double moved = 0;
  for (std::size_t v = 0; v < doubt.size(); ++v) {
    const double share = (shares[v].x() - least_share) / (full_share - least_share);
    const double length = normals[v].norm();
    if (!(share > 0 && length > 0)) continue;
    mesh.positions[v] -= depth * std::min(share, 1.0) / length * normals[v];
    ++moved;
  }
  return doubt.empty() ? 0 : moved / static_cast<double>(doubt.size());
}

}  // namespace transformesh
