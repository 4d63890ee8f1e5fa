#include "flow/diffusion_step.h"

#include "transformesh/measure.h"

namespace transformesh {

DiffusionStep::DiffusionStep(const Mesh& mesh)
    : mesh_(mesh),
      laplacian_(cotangent_laplacian(mesh, CotangentBounds::each_triangle)),
      unknowns_{std::vector<Index>(mesh.positions.size(), no_index), {}} {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const bool is_border = laplacian_.is_border[v] != 0;
    border_count_ += is_border;
    if (is_border || !(laplacian_.areas[v] > 0)) continue;
    unknowns_.row_of[v] = static_cast<Index>(unknowns_.vertex_of.size());
    unknowns_.vertex_of.push_back(static_cast<Index>(v));
  }
}

/// Returns -L, where L is the cotangent matrix, restricted to the free vertices. Fixed neighbors
/// contribute to the diagonal only.
DiffusionStep::Matrix DiffusionStep::stiffness() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * laplacian_.edges.size());
  const std::vector<Index>& row_of = unknowns_.row_of;
  for (const auto& [from, to, weight] : laplacian_.edges) {
    const auto a = static_cast<int>(row_of[from]), b = static_cast<int>(row_of[to]);
    const bool is_a_free = row_of[from] != no_index, is_b_free = row_of[to] != no_index;
    if (is_a_free) entries.emplace_back(a, a, weight / 2);
    if (is_b_free) entries.emplace_back(b, b, weight / 2);
    if (!is_a_free || !is_b_free) continue;
    entries.emplace_back(a, b, -weight / 2);
    entries.emplace_back(b, a, -weight / 2);
  }
  const auto size = static_cast<Eigen::Index>(unknowns_.vertex_of.size());
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::VectorXd DiffusionStep::areas() const {
  Eigen::VectorXd areas(static_cast<Eigen::Index>(unknowns_.vertex_of.size()));
  for (Eigen::Index row = 0; row < areas.size(); ++row)
    areas[row] = laplacian_.areas[unknowns_.vertex_of[static_cast<std::size_t>(row)]];
  return areas;
}

std::vector<Vec3> DiffusionStep::curvature_vectors(const std::vector<Vec3>& positions) const {
  std::vector<Vec3> vectors(positions.size(), Vec3::Zero());
  for (const auto& [from, to, weight] : laplacian_.edges) {
    const Vec3 pull = weight / 2 * (positions[to] - positions[from]);
    vectors[from] += pull;
    vectors[to] -= pull;
  }
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    const bool is_fixed = unknowns_.row_of[v] == no_index;
    vectors[v] = is_fixed ? Vec3::Zero() : Vec3(vectors[v] / laplacian_.areas[v]);
  }
  return vectors;
}

Relaxation DiffusionStep::second_order(double span) const {
  return {unknowns_, areas(), stiffness(), span};
}

Eigen::VectorXd DiffusionStep::curvature_sums() const {
  const std::vector<Vec3> vectors = curvature_vectors(mesh_.positions);
  const std::vector<Vec3> normals = vertex_normals(mesh_);
  Eigen::VectorXd sums(static_cast<Eigen::Index>(unknowns_.vertex_of.size()));
  for (Eigen::Index row = 0; row < sums.size(); ++row) {
    const Index v = unknowns_.vertex_of[static_cast<std::size_t>(row)];
    sums[row] = -vectors[v].dot(normals[v]);
  }
  return sums;
}

std::vector<double> DiffusionStep::diffusion_speeds(const std::vector<double>& offsets) const {
  std::vector<double> result(mesh_.positions.size(), 0);
  const std::vector<Index>& vertices = unknowns_.vertex_of;
  if (vertices.empty()) return result;
  const Matrix laplacian = stiffness();
  const Eigen::VectorXd masses = areas();
  Eigen::VectorXd moved(masses.size());
  for (Eigen::Index row = 0; row < moved.size(); ++row)
    moved[row] = offsets[vertices[static_cast<std::size_t>(row)]];
  const Eigen::VectorXd sums = curvature_sums() - (laplacian * moved).cwiseQuotient(masses);
  const Eigen::VectorXd speeds = -(laplacian * sums).cwiseQuotient(masses);
  for (Eigen::Index row = 0; row < speeds.size(); ++row)
    result[vertices[static_cast<std::size_t>(row)]] = speeds[row];
  return result;
}

Relaxation DiffusionStep::fourth_order(double span) const {
  const Matrix laplacian = stiffness();
  const Eigen::VectorXd masses = areas();
  return {unknowns_, masses, laplacian * masses.cwiseInverse().asDiagonal() * laplacian, span};
}

}  // namespace transformesh
