#include "remesh/sizing.h"

#include <cmath>
#include <exception>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Sizes that are small at one pole and large at the other, with slope 0.2.
double wanted_size(const Vec3& point) { return 0.12 + 0.1 * point.z(); }

Mesh with_sizes(Mesh mesh) {
  Column& column = mesh.vertex_columns.get("wanted", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    column.values[v] = wanted_size(mesh.positions[v]);
  }
  return mesh;
}

RemeshOptions with_column(int iterations) {
  RemeshOptions options;
  options.min_edge = 0.7;
  options.max_edge = 1.5;
  options.size_column = "wanted";
  options.iterations = iterations;
  return options;
}

std::string refusal(const Mesh& mesh, const RemeshOptions& options) {
  Mesh copy = mesh;
  try {
    remesh(copy, options);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("edges follow the sizes of a column") {
  Mesh mesh = with_sizes(icosphere(4));
  remesh(mesh, with_column(6));
  CHECK(is_oriented_manifold(mesh));
  CHECK(euler_number(mesh) == 2);
  CHECK(find_intersections(mesh).empty());
  CHECK(angles(mesh).minimum_deg > 20);

  // sizes at the final positions of the vertices
  double least = 10;
  double longest = 0;
  double sum = 0;
  const auto edges = edge_faces(mesh);
  for (const auto& [edge, faces] : edges) {
    const Vec3& a = mesh.positions[edge.first];
    const Vec3& b = mesh.positions[edge.second];
    const double relative = 2 * (b - a).norm() / (wanted_size(a) + wanted_size(b));
    least = std::min(least, relative);
    longest = std::max(longest, relative);
    sum += relative;
  }
  CHECK(least > 0.6);
  CHECK(longest < 1.6);
  const double mean = sum / static_cast<double>(edges.size());
  CHECK(mean > 0.95);
  CHECK(mean < 1.15);

  const Column& column = *mesh.vertex_columns.find("wanted");
  REQUIRE(column.values.size() == mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    CHECK(column.values[v] == doctest::Approx(wanted_size(mesh.positions[v])).epsilon(0.05));
  }
}

TEST_CASE("a column of equal sizes equals that length") {
  Mesh mesh = icosphere(3);
  Mesh other = mesh;
  mesh.vertex_columns.get("wanted", Scalar::float64, mesh.positions.size())
      .values.assign(mesh.positions.size(), 0.25);
  RemeshOptions options = with_column(3);
  remesh(mesh, options);
  options.size_column.clear();
  options.min_edge *= 0.25;
  options.max_edge *= 0.25;
  remesh(other, options);
  CHECK(is_same(mesh, other));
}

TEST_CASE("small components are judged by their own sizes") {
  // the small ball is kept if its own sizes are small, and removed otherwise
  Mesh mesh = joined(icosphere(3), moved(scaled(icosphere(2), 0.05), {3, 0, 0}));
  Column& column = mesh.vertex_columns.get("wanted", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    column.values[v] = mesh.positions[v].x() > 2 ? 0.02 : 0.2;
  }
  Mesh kept = mesh;
  CHECK(remesh(kept, with_column(2)).components_removed.count == 0);
  column.values.assign(mesh.positions.size(), 0.2);
  CHECK(remesh(mesh, with_column(2)).components_removed.count == 1);
}

TEST_CASE("a column with invalid sizes is refused") {
  Mesh mesh = icosphere(1);
  CHECK(refusal(mesh, with_column(1)).find("no vertex property 'wanted'") != std::string::npos);
  mesh = with_sizes(mesh);
  for (const double bad : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    Mesh spoiled = mesh;
    spoiled.vertex_columns.find("wanted")->values[5] = bad;
    CHECK(refusal(spoiled, with_column(1)).find("vertex 5 has the size") != std::string::npos);
  }
  mesh.vertex_columns.find("wanted")->values.assign(mesh.positions.size(), 1e-6);
  CHECK(refusal(mesh, with_column(1)).find("million faces") != std::string::npos);
  RemeshOptions both = with_column(1);
  both.adaptive_error = 0.1;
  CHECK(refusal(with_sizes(icosphere(1)), both).find("not from both") != std::string::npos);
}

TEST_CASE("graded sizes are the largest that grow slowly enough") {
  const Mesh mesh = icosphere(3);
  const EditableMesh editable(mesh);
  Random random(3);
  std::vector<double> given(mesh.positions.size());
  for (double& size : given) size = random.below(20) == 0 ? random.uniform(0.01, 0.1) : 1;
  std::vector<double> graded = given;
  grade_sizes(editable, graded);

  std::vector<double> bound = given;  // the smallest of the limits that the neighbors set
  for (const auto& [edge, faces] : edge_faces(mesh)) {
    const auto [a, b] = edge;
    const double length = (mesh.positions[a] - mesh.positions[b]).norm();
    bound[a] = std::min(bound[a], graded[b] + 0.3 * length);
    bound[b] = std::min(bound[b], graded[a] + 0.3 * length);
  }
  std::size_t lowered = 0;
  for (std::size_t v = 0; v < graded.size(); ++v) {
    CHECK(graded[v] == doctest::Approx(bound[v]).epsilon(1e-14));
    lowered += graded[v] < given[v];
  }
  CHECK(lowered > 300);
}
