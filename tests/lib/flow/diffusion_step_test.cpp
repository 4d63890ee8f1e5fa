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

TEST_CASE("curvature vectors apply the cotangents of the mesh to other positions") {
  // Half of a ball, stretched so that some angles are obtuse.
  Mesh mesh = test::icosphere(3);
  std::erase_if(mesh.faces, [&](const Face& face) {
    return mesh.positions[face[0]].z() + mesh.positions[face[1]].z() + mesh.positions[face[2]].z() <
           0;
  });
  for (Vec3& p : mesh.positions) p.x() *= 3;
  const DiffusionStep step(mesh);
  CHECK(step.border_count() > 20);
  const CotangentLaplacian laplacian = cotangent_laplacian(mesh, CotangentBounds::each_triangle);
  std::vector<Vec3> others = mesh.positions;
  for (Vec3& p : others) p.z() += p.x() * p.y();
  const std::vector<Vec3> vectors = step.curvature_vectors(others);
  for (Index v = 0; v < others.size(); ++v) {
    const bool is_fixed = laplacian.is_border[v] != 0 || laplacian.areas[v] == 0;
    const Vec3 wanted = is_fixed ? Vec3::Zero() : laplacian_at(mesh, v, others);
    CHECK((laplacian.areas[v] * vectors[v] - wanted).norm() < 1e-13);
  }
}

TEST_CASE("a short relaxation has the slopes and curvatures of its equations") {
  // For y' = b + A y, y(t) = t b + t^2 / 2 A b up to third order in t.
  Mesh mesh = test::icosphere(2);
  for (Vec3& p : mesh.positions) p *= 1 + 0.1 * p.z() * p.z();
  const DiffusionStep step(mesh);
  const CotangentLaplacian laplacian = cotangent_laplacian(mesh, CotangentBounds::each_triangle);
  const auto applied = [&](const std::vector<double>& f) {
    std::vector<double> result(f.size());
    for (Index v = 0; v < f.size(); ++v) result[v] = laplacian_at(mesh, v, f) / laplacian.areas[v];
    return result;
  };
  std::vector<double> rates;
  for (const Vec3& p : mesh.positions) rates.push_back(p.x() * p.y() + p.z());
  const auto check = [&](const Relaxation& equations, double span,
                         const std::vector<double>& curvature, double sign) {
    const std::vector<double> result = equations.after(rates);
    double worst = 0, largest = 0;
    for (std::size_t v = 0; v < rates.size(); ++v) {
      const double second = sign * span * span / 2 * curvature[v];
      worst = std::max(worst, std::abs(result[v] - span * rates[v] - second));
      largest = std::max(largest, std::abs(second));
    }
    CHECK(worst < 0.01 * largest);
  };
  check(step.second_order(2e-5), 2e-5, applied(rates), 1);
  check(step.fourth_order(1e-8), 1e-8, applied(applied(rates)), -1);
}

TEST_CASE("speeds of surface diffusion sum up to no volume, and offsets shift the curvature") {
  Mesh mesh = test::icosphere(3);
  for (Vec3& p : mesh.positions) p *= 1 + 0.1 * p.z() * p.z();
  const DiffusionStep step(mesh);
  const CotangentLaplacian laplacian = cotangent_laplacian(mesh, CotangentBounds::each_triangle);
  const auto sum_of = [&](const std::vector<double>& speeds) {
    double sum = 0;
    for (std::size_t v = 0; v < speeds.size(); ++v) sum += laplacian.areas[v] * speeds[v];
    return sum;
  };
  const std::vector<double> none(mesh.positions.size(), 0);
  const std::vector<double> speeds = step.diffusion_speeds(none);
  CHECK(std::abs(sum_of(speeds)) < 1e-10);
  CHECK(std::abs(sum_of(step.fourth_order(1e-3).after(speeds))) < 1e-10);

  std::vector<double> offsets;
  for (const Vec3& p : mesh.positions) offsets.push_back(0.01 * p.x());
  const std::vector<double> shifted = step.diffusion_speeds(offsets);
  std::vector<double> inner(offsets.size());
  for (Index v = 0; v < offsets.size(); ++v)
    inner[v] = laplacian_at(mesh, v, offsets) / laplacian.areas[v];
  for (Index v = 0; v < offsets.size(); ++v) {
    const double wanted = laplacian_at(mesh, v, inner) / laplacian.areas[v];
    CHECK(shifted[v] - speeds[v] == Approx(wanted).epsilon(1e-6).scale(0.01));
  }
}

TEST_CASE("vertices without faces or area do not move") {
  Mesh mesh = test::cube();
  mesh.positions.emplace_back(9, 9, 9);
  const DiffusionStep cube(mesh);
  CHECK(cube.curvature_vectors(mesh.positions)[8] == Vec3::Zero());
  CHECK(cube.second_order(0.1).after(mesh.positions)[8] == Vec3::Zero());
  Mesh nothing;
  nothing.positions.assign(3, Vec3::Zero());
  nothing.faces = {{0, 1, 2}};
  const DiffusionStep step(nothing);
  const std::vector<double> ones(3, 1), zeros(3, 0);
  CHECK(step.second_order(1).after(ones) == zeros);
  CHECK(step.fourth_order(1).after(ones) == zeros);
  CHECK(step.diffusion_speeds(ones) == zeros);
}
