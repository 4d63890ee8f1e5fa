#include "views/photo/thin_plate.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Returns the umbrella operator as a matrix, built row by row from the faces.
Eigen::MatrixXd laplacian_matrix(const Mesh& mesh) {
  const auto count = static_cast<Eigen::Index>(mesh.positions.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  for (const Face& face : mesh.faces) {
    for (const Index a : face) {
      for (const Index b : face) {
        if (a != b) matrix(a, b) = 1;
      }
    }
  }
  for (Eigen::Index row = 0; row < count; ++row) {
    matrix.row(row) /= std::max(matrix.row(row).sum(), 1.0);
    matrix(row, row) -= 1;
  }
  return matrix;
}

ThinPlateProblem random_problem(const Mesh& mesh, double stiffness) {
  test::Random random(4);
  ThinPlateProblem problem;
  problem.normals = vertex_normals(mesh);
  problem.stiffness = stiffness;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    problem.gradient.push_back(random.uniform(-1, 1));
    problem.curvature.push_back(random.uniform(0.2, 3));
  }
  return problem;
}

/// Returns the minimum by a dense solver.
Eigen::VectorXd dense_step(const Mesh& mesh, const ThinPlateProblem& problem) {
  const auto count = static_cast<Eigen::Index>(mesh.positions.size());
  const Eigen::MatrixXd bend = laplacian_matrix(mesh);
  const Eigen::MatrixXd energy = problem.stiffness * bend.transpose() * bend;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd force(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    force[a] = -problem.gradient[static_cast<std::size_t>(a)];
    for (Eigen::Index b = 0; b < count; ++b) {
      const Vec3& normal = problem.normals[static_cast<std::size_t>(a)];
      system(a, b) = energy(a, b) * normal.dot(problem.normals[static_cast<std::size_t>(b)]);
      force[a] -= energy(a, b) * normal.dot(mesh.positions[static_cast<std::size_t>(b)]);
    }
    system(a, a) += problem.curvature[static_cast<std::size_t>(a)];
  }
  return system.ldlt().solve(force);
}

}  // namespace

TEST_CASE("the umbrella is the way to the mean of the neighbors, one for each edge") {
  const Mesh mesh = test::icosphere(1);
  const UniformLaplacian laplacian(mesh);
  std::vector<Vec3> ways;
  laplacian.apply(mesh.positions, ways);
  const Eigen::MatrixXd matrix = laplacian_matrix(mesh);
  for (std::size_t v = 0; v < ways.size(); ++v) {
    Vec3 expected = Vec3::Zero();
    for (std::size_t w = 0; w < ways.size(); ++w)
      expected +=
          matrix(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(w)) * mesh.positions[w];
    CHECK((ways[v] - expected).norm() < 1e-14);
  }
}

TEST_CASE("the step comes to within the residual of the minimum") {
  const Mesh mesh = test::icosphere(2);
  const UniformLaplacian laplacian(mesh);
  for (const double stiffness : {0.0, 0.5, 3.0}) {
    const ThinPlateProblem problem = random_problem(mesh, stiffness);
    const std::vector<double> steps = thin_plate_step(mesh, laplacian, problem);
    const Eigen::VectorXd exact = dense_step(mesh, problem);
    const Eigen::Map<const Eigen::VectorXd> found(steps.data(), exact.size());
    CHECK((found - exact).norm() < (stiffness == 0 ? 1e-14 : 0.1) * exact.norm());
  }
}

TEST_CASE("a dent without data is smoothed away, and one with data stays") {
  Mesh mesh = test::icosphere(3);
  mesh.positions[100] *= 0.9;
  const UniformLaplacian laplacian(mesh);
  ThinPlateProblem problem{vertex_normals(mesh), std::vector<double>(mesh.positions.size(), 0),
                           std::vector<double>(mesh.positions.size(), 0), 1};
  // The whole sphere shrinks as well, so only the movement relative to the other vertices counts.
  const auto out_of_dent = [&] {
    const std::vector<double> steps = thin_plate_step(mesh, laplacian, problem);
    return steps[100] - steps[300];
  };
  const double free = out_of_dent();
  CHECK(free > 0.04);
  std::fill(problem.curvature.begin(), problem.curvature.end(), 100.0);
  CHECK(std::abs(out_of_dent()) < 0.05 * free);
}

TEST_CASE("borders are free, and vertices without faces stay") {
  // A flat sheet has no bending energy, and its border is not pulled inwards.
  Mesh mesh;
  for (int i = 0; i < 36; ++i) mesh.positions.emplace_back(i % 6, i / 6, 0);
  for (Index i = 0; i < 5; ++i) {
    for (Index j = 0; j < 5; ++j) {
      const Index a = 6 * i + j;
      mesh.faces.push_back({a, a + 1, a + 7});
      mesh.faces.push_back({a, a + 7, a + 6});
    }
  }
  mesh.positions.emplace_back(9, 9, 9);
  const UniformLaplacian laplacian(mesh);
  const std::vector<double> none(mesh.positions.size(), 0);
  const ThinPlateProblem problem{vertex_normals(mesh), none, none, 1};
  for (const double step : thin_plate_step(mesh, laplacian, problem)) CHECK(step == 0);
  std::vector<Vec3> bent;
  laplacian.apply_bending(mesh.positions, bent);
  for (const Vec3& b : bent) CHECK(b.norm() < 1e-14);
}
