#include "views/photo/thin_plate.h"

#include <numeric>

#include "mesh/edges.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

// Stopping rule of the conjugate gradient method: the largest number of iterations, and the ratio
// of final to initial residual. Low precision suffices, because the next step of an evolution
// continues from the result.
constexpr int most_iterations = 20;
constexpr double residual_share = 0.05;
/// Diagonal entry of L^T L if every vertex has six neighbors. L is the uniform Laplacian; the
/// column of a vertex has one entry -1 and six entries 1 / 6.
constexpr double bending_diagonal = 7.0 / 6;
constexpr std::size_t vertices_per_task = 4096;

void for_vertices(std::size_t count, const std::function<void(std::size_t)>& body) {
  parallel_for(count, vertices_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) body(v);
  });
}

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// The matrix H + stiffness N^T L^T L N of the energy. H is the diagonal matrix of the curvatures
/// h, and N maps movements along normals to vectors.
class Plate {
 public:
  Plate(const UniformLaplacian& laplacian, const ThinPlateProblem& problem)
      : laplacian_(laplacian),
        problem_(problem),
        moved_(problem.normals.size()),
        bent_(problem.normals.size()) {}

  void apply(std::span<const double> steps, std::vector<double>& result) {
    for (std::size_t v = 0; v < steps.size(); ++v) moved_[v] = steps[v] * problem_.normals[v];
    laplacian_.apply_bending(moved_, bent_);
    for (std::size_t v = 0; v < steps.size(); ++v) {
      result[v] =
          problem_.curvature[v] * steps[v] + problem_.stiffness * problem_.normals[v].dot(bent_[v]);
    }
  }

  /// Returns the negative gradient of the energy with respect to the movements, if all movements
  /// are zero.
  std::vector<double> force(std::span<const Vec3> positions) {
    laplacian_.apply_bending(positions, bent_);
    std::vector<double> result(positions.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
      result[v] = -problem_.gradient[v] - problem_.stiffness * problem_.normals[v].dot(bent_[v]);
    }
    return result;
  }

  double diagonal(std::size_t vertex) const {
    const bool can_move = problem_.normals[vertex] != Vec3::Zero();
    const double bending = can_move ? problem_.stiffness * bending_diagonal : 0;
    return problem_.curvature[vertex] + bending;
  }

 private:
  const UniformLaplacian& laplacian_;
  const ThinPlateProblem& problem_;
  std::vector<Vec3> moved_;
  std::vector<Vec3> bent_;
};

}  // namespace

UniformLaplacian::UniformLaplacian(const Mesh& mesh) : offsets_(mesh.positions.size() + 1, 0) {
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

void UniformLaplacian::apply_bending(std::span<const Vec3> values,
                                     std::vector<Vec3>& result) const {
  std::vector<Vec3> bend;
  apply(values, bend);
  for_vertices(values.size(), [&](std::size_t v) {
    if (share_[v] == 0) bend[v].setZero();
  });
  result.resize(values.size());
  for_vertices(values.size(), [&](std::size_t v) {
    Vec3 sum = -bend[v];
    for (const Index neighbor : neighbors(static_cast<Index>(v)))
      sum += share_[neighbor] * bend[neighbor];
    result[v] = sum;
  });
}

std::vector<double> thin_plate_step(const Mesh& mesh, const UniformLaplacian& laplacian,
                                    const ThinPlateProblem& problem) {
  const std::size_t count = mesh.positions.size();
  Plate plate(laplacian, problem);
  std::vector<double> residual = plate.force(mesh.positions);
  std::vector<double> steps(count, 0);
  std::vector<double> scaled(count, 0);
  std::vector<double> image(count);
  const auto precondition = [&] {
    for (std::size_t v = 0; v < count; ++v) {
      const double diagonal = plate.diagonal(v);
      scaled[v] = diagonal > 0 ? residual[v] / diagonal : 0;
    }
    return dot(residual, scaled);
  };

  double left = precondition();
  const double enough = residual_share * residual_share * left;
  std::vector<double> direction = scaled;
  for (int i = 0; i < most_iterations && left > 0 && left >= enough; ++i) {
    plate.apply(direction, image);
    const double curvature = dot(direction, image);
    if (!(curvature > 0)) break;
    const double length = left / curvature;
    for (std::size_t v = 0; v < count; ++v) {
      steps[v] += length * direction[v];
      residual[v] -= length * image[v];
    }
    const double before = left;
    left = precondition();
    for (std::size_t v = 0; v < count; ++v) direction[v] = scaled[v] + left / before * direction[v];
  }
  return steps;
}

}  // namespace transformesh
