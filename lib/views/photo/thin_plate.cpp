#include "views/photo/thin_plate.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <cmath>
#include <numeric>

#include "mesh/edges.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr int most_iterations = 20;
constexpr double residual_share = 0.05;
constexpr double bending_diagonal = 7.0 / 6;  ///< of L^T L at a vertex with six neighbors
constexpr std::size_t vertices_per_task = 4096;

void for_vertices(std::size_t count, const std::function<void(std::size_t)>& body) {
  parallel_for(count, vertices_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) body(v);
  });
}

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The system of the energy's minimum: matrix * steps = force.
struct PlateSystem {
  SparseMatrix matrix;  ///< H + stiffness N^T L^T L N; H has the curvatures, N the normals
  Eigen::VectorXd force;
  Eigen::VectorXd scale;  ///< 1 / root of the diagonal of a regular mesh; 0 if nothing moves
};

void scale_to_normals(const ThinPlateProblem& problem, SparseMatrix& bending) {
  for (Eigen::Index j = 0; j < bending.outerSize(); ++j)
    for (SparseMatrix::InnerIterator entry(bending, j); entry; ++entry)
      entry.valueRef() *=
          problem.stiffness * problem.normals[static_cast<std::size_t>(entry.row())].dot(
                                  problem.normals[static_cast<std::size_t>(j)]);
}

Eigen::VectorXd force_of(std::span<const Vec3> positions, const SparseMatrix& umbrella,
                         const ThinPlateProblem& problem) {
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> points(
      positions.data()->data(), std::ssize(positions), 3);
  const Eigen::MatrixXd bent = umbrella.transpose() * (umbrella * points).eval();
  Eigen::VectorXd force(std::ssize(positions));
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto row = static_cast<Eigen::Index>(v);
    force[row] = -problem.gradient[v] -
                 problem.stiffness * bent.row(row).dot(problem.normals[v].transpose());
  }
  return force;
}

PlateSystem system_of(std::span<const Vec3> positions, const UniformLaplacian& laplacian,
                      const ThinPlateProblem& problem) {
  const SparseMatrix umbrella = laplacian.matrix();
  PlateSystem system;
  system.force = force_of(positions, umbrella, problem);
  system.matrix = umbrella.transpose() * umbrella;
  scale_to_normals(problem, system.matrix);
  system.scale.resize(system.force.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto row = static_cast<Eigen::Index>(v);
    system.matrix.coeffRef(row, row) += problem.curvature[v];
    const bool can_bend = problem.normals[v] != Vec3::Zero();
    const double diagonal =
        problem.curvature[v] + (can_bend ? problem.stiffness * bending_diagonal : 0);
    const bool can_move = system.matrix.coeff(row, row) > 0;
    system.scale[row] = can_move ? 1 / std::sqrt(diagonal) : 0;
  }
  return system;
}

}  // namespace

UniformLaplacian::UniformLaplacian(const Mesh& mesh) : offsets_(mesh.positions.size() + 1, 0) {
  // Each edge makes its ends neighbors of each other.
  const Edges edges(mesh);
  std::vector<char> is_border(mesh.positions.size(), 0);
  const auto for_ends = [&](const auto& body) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const Index halfedge = edges.halfedges(e)[0];
      body(e, halfedge_source(mesh, halfedge), halfedge_target(mesh, halfedge));
    }
  };
  for_ends([&](std::size_t e, Index a, Index b) {
    ++offsets_[a + 1];
    ++offsets_[b + 1];
    if (edges.halfedges(e).size() == 1) is_border[a] = is_border[b] = 1;
  });
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());

  std::vector<Index> next(offsets_.begin(), offsets_.end() - 1);
  ids_.resize(offsets_.back());
  for_ends([&](std::size_t, Index a, Index b) {
    ids_[next[a]++] = b;
    ids_[next[b]++] = a;
  });
  share_.resize(mesh.positions.size(), 0);
  for (Index v = 0; v < share_.size(); ++v) {
    const std::size_t count = neighbors(v).size();
    if (count > 0 && !is_border[v]) share_[v] = 1 / static_cast<double>(count);
  }
}

void UniformLaplacian::apply(std::span<const Vec3> values, std::vector<Vec3>& result) const {
  result.resize(values.size());
  for_vertices(values.size(), [&](std::size_t v) {
    Vec3 sum = Vec3::Zero();
    const std::span<const Index> around = neighbors(static_cast<Index>(v));
    for (const Index neighbor : around) sum += values[neighbor];
    result[v] = around.empty() ? sum : Vec3(sum / static_cast<double>(around.size()) - values[v]);
  });
}

Eigen::SparseMatrix<double> UniformLaplacian::matrix() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(ids_.size() + share_.size());
  for (Index v = 0; v < share_.size(); ++v) {
    // An entry of each diagonal, so that others can be added there.
    entries.emplace_back(v, v, share_[v] == 0 ? 0 : -1);
    if (share_[v] == 0) continue;
    for (const Index neighbor : neighbors(v)) entries.emplace_back(v, neighbor, share_[v]);
  }
  const auto count = std::ssize(share_);
  SparseMatrix result(count, count);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

std::vector<double> thin_plate_step(const Mesh& mesh, const UniformLaplacian& laplacian,
                                    const ThinPlateProblem& problem) {
  if (mesh.positions.empty()) return {};
  const PlateSystem system = system_of(mesh.positions, laplacian, problem);
  const auto scale = system.scale.asDiagonal();
  const SparseMatrix scaled = scale * system.matrix * scale;
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper, Eigen::IdentityPreconditioner>
      solver;
  solver.setMaxIterations(most_iterations);
  solver.setTolerance(residual_share);
  solver.compute(scaled);
  const Eigen::VectorXd steps = scale * solver.solve(scale * system.force);
  return {steps.begin(), steps.end()};
}

}  // namespace transformesh
