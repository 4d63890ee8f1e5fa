#include "flow/diffusion_step.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers/shapes.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Sum over the neighbors j of a vertex of weight / 2 * (f[j] - f[v]), by a search for faces.
template <class Value>
Value laplacian_at(const Mesh& mesh, Index v, const std::vector<Value>& f) {
  Value sum = 0 * f[v];
  for (const Face& face : mesh.faces)
    for (int i = 0; i < 3; ++i) {
      const Index a = face[i], b = face[(i + 1) % 3], apex = face[(i + 2) % 3];
      if (a != v && b != v) continue;
      const Vec3 u = mesh.positions[a] - mesh.positions[apex];
      const Vec3 w = mesh.positions[b] - mesh.positions[apex];
      const double cotangent = u.dot(w) / u.cross(w).norm();
      sum += cotangent / 2 * (f[a == v ? b : a] - f[v]);
    }
  return sum;
}

}  // namespace

TEST_CASE("the implicit step solves its equation, also where neighbors are fixed") {
  // Half of a ball, stretched so that some angles are obtuse.
  Mesh mesh = test::icosphere(3);
  std::erase_if(mesh.faces, [&](const Face& face) {
    return mesh.positions[face[0]].z() + mesh.positions[face[1]].z() + mesh.positions[face[2]].z() <
           0;
  });
  for (Vec3& p : mesh.positions) p.x() *= 3;
  const DiffusionStep step(mesh);
  CHECK(step.border_count() > 20);
  const double span = 0.03;
  const std::vector<Vec3> displacements = step.second_order(span);
  std::vector<Vec3> ends = mesh.positions;
  for (std::size_t v = 0; v < ends.size(); ++v) ends[v] += displacements[v];
  const CotangentLaplacian laplacian = cotangent_laplacian(mesh, CotangentBounds::each_triangle);
  for (Index v = 0; v < ends.size(); ++v) {
    if (laplacian.is_border[v] != 0 || laplacian.areas[v] == 0) {
      CHECK(displacements[v] == Vec3::Zero());
      continue;
    }
    const Vec3 right = span * laplacian_at(mesh, v, ends);
    CHECK((laplacian.areas[v] * displacements[v] - right).norm() < 1e-13);
  }
}

TEST_CASE("the speeds of surface diffusion solve their equation and sum up to no volume") {
  Mesh mesh = test::icosphere(3);
  for (Vec3& p : mesh.positions) p *= 1 + 0.1 * p.z() * p.z();
  const DiffusionStep step(mesh);
  const CotangentLaplacian laplacian = cotangent_laplacian(mesh, CotangentBounds::each_triangle);
  const auto sum_of = [&](const std::vector<double>& speeds) {
    double sum = 0;
    for (std::size_t v = 0; v < speeds.size(); ++v) sum += laplacian.areas[v] * speeds[v];
    return sum;
  };
  const std::vector<double> at_once = step.fourth_order(0);
  CHECK(std::abs(sum_of(at_once)) < 1e-10);

  // (M + span L inverse(M) L) v = M v_0, where v_0 are the speeds for a span of 0.
  const double span = 1e-3;
  const std::vector<double> speeds = step.fourth_order(span);
  CHECK(std::abs(sum_of(speeds)) < 1e-10);
  std::vector<double> inner(speeds.size());
  for (Index v = 0; v < speeds.size(); ++v)
    inner[v] = laplacian_at(mesh, v, speeds) / laplacian.areas[v];
  double worst = 0, largest = 0;
  for (Index v = 0; v < speeds.size(); ++v) {
    const double left = laplacian.areas[v] * speeds[v] + span * laplacian_at(mesh, v, inner);
    worst = std::max(worst, std::abs(left - laplacian.areas[v] * at_once[v]));
    largest = std::max(largest, std::abs(laplacian.areas[v] * at_once[v]));
  }
  CHECK(worst < 1e-8 * largest);
}

TEST_CASE("vertices without faces or area do not move") {
  Mesh mesh = test::cube();
  mesh.positions.emplace_back(9, 9, 9);
  CHECK(DiffusionStep(mesh).second_order(0.1)[8] == Vec3::Zero());
  Mesh nothing;
  nothing.positions.assign(3, Vec3::Zero());
  nothing.faces = {{0, 1, 2}};
  for (const Vec3& moved : DiffusionStep(nothing).second_order(1)) CHECK(moved == Vec3::Zero());
  CHECK(DiffusionStep(nothing).fourth_order(1) == std::vector<double>(3, 0));
}
