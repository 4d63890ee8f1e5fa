#include "flow/curvature_flows.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/revolution_flow.h"
#include "helpers/shapes.h"
#include "transformesh/measure.h"
#include "transformesh/shapes.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Moves a mesh by steps of the flow's own integrator; faces do not change.
void advance(Mesh& mesh, const char* name, double duration, int steps) {
  const Motion motion = make_flow(name).motion;
  REQUIRE(motion.displacement);
  const double span = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const auto displacements = motion.displacement(mesh, {i * span, span, 0}, Progress());
    for (std::size_t v = 0; v < displacements.size(); ++v) mesh.positions[v] += displacements[v];
  }
}

double mean_radius(const Mesh& mesh) {
  double sum = 0;
  for (const Vec3& p : mesh.positions) sum += p.norm();
  return sum / static_cast<double>(mesh.positions.size());
}

double radius_spread(const Mesh& mesh) {
  double low = 1e300, high = 0;
  for (const Vec3& p : mesh.positions) {
    low = std::min(low, p.norm());
    high = std::max(high, p.norm());
  }
  return (high - low) / mean_radius(mesh);
}

/// Returns the relative error of the squared radius of a shrinking unit sphere at time 0.15. The
/// exact squared radius is 1 - 4 * 0.15 = 0.4.
double sphere_error(std::size_t faces, int steps) {
  Mesh sphere = make_sphere(Vec3::Zero(), 1, faces);
  advance(sphere, "mean-curvature", 0.15, steps);
  return std::abs(std::pow(mean_radius(sphere), 2) / 0.4 - 1);
}

/// Returns the volume, computed without the library.
double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces)
    sum += mesh.positions[a].dot(mesh.positions[b].cross(mesh.positions[c]));
  return sum / 6;
}

Mesh ellipsoid(double radius, double half_height, int subdivisions) {
  Mesh mesh = test::icosphere(subdivisions);
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(Vec3(radius, radius, half_height));
  return mesh;
}

double shortest_edge(const Mesh& mesh) { return edge_lengths(mesh).minimum; }

}  // namespace

TEST_CASE("under mean-curvature flow a sphere has r^2 = r0^2 - 4 t, and the error converges") {
  const double coarse = sphere_error(1250, 40), fine = sphere_error(5000, 80);
  MESSAGE("errors of r^2: ", coarse, " ", fine);
  CHECK(fine < 0.001);
  CHECK(fine < 0.3 * coarse);
}

TEST_CASE("ten steps take a sphere to 0.4 of its squared radius within 0.05 %") {
  // The same steps by extrapolated implicit Euler steps, a method of second order, have an error of
  // 0.3 %.
  const double error = sphere_error(5000, 10);
  MESSAGE("error of r^2: ", error);
  CHECK(error < 5e-4);
}

TEST_CASE("steps of flows by curvature are of second order in their span") {
  const auto end = [](const char* name, double duration, int steps) {
    Mesh mesh = ellipsoid(0.7, 1, 2);
    advance(mesh, name, duration, steps);
    return mesh.positions;
  };
  const auto difference = [](const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v) sum += (a[v] - b[v]).squaredNorm();
    return std::sqrt(sum);
  };
  const auto check = [&](const char* name, double duration) {
    const auto coarse = end(name, duration, 64), middle = end(name, duration, 128),
               fine = end(name, duration, 256);
    const double order = std::log2(difference(coarse, middle) / difference(middle, fine));
    MESSAGE(std::string(name), ": order ", order);
    CHECK(order > 1.8);
  };
  check("mean-curvature", 0.05);
  check("volume-preserving-curvature", 0.05);
  check("surface-diffusion", 0.002);
}

TEST_CASE("the axes of an ellipsoid agree with the one-dimensional solver at all times") {
  Mesh mesh = ellipsoid(0.5, 1, 4);
  test::RevolutionFlow profile(test::ellipsoid_profile(0.5, 1, 201));
  for (int i = 1; i <= 3; ++i) {
    advance(mesh, "mean-curvature", 0.02, 20);
    profile.advance_to(0.02 * i);
    const Box box = bounding_box(mesh);
    MESSAGE("axes ", box.max().x(), " ", box.max().z(), " and ",
            profile.radius(profile.points().size() / 2), " ", profile.points().back().y());
    CHECK(box.max().x() == Approx(profile.radius(profile.points().size() / 2)).epsilon(0.01));
    CHECK(box.max().z() == Approx(profile.points().back().y()).epsilon(0.01));
  }
}

TEST_CASE("volumes and necks of a ring and a dumbbell agree with the one-dimensional solver") {
  Mesh ring = test::torus(1, 0.4, 80, 40);
  test::RevolutionFlow profile(test::torus_profile(1, 0.4, 200));
  for (int i = 1; i <= 3; ++i) {
    advance(ring, "mean-curvature", 0.02, 20);
    profile.advance_to(0.02 * i);
    MESSAGE("volumes ", volume_of(ring), " and ", profile.volume());
    CHECK(volume_of(ring) == Approx(profile.volume()).epsilon(0.01));
  }

  ShapeOptions options;
  options.kind = "dumbbell";
  options.neck = 0.25;
  options.faces = 5000;
  Mesh dumbbell = make_shape(options);
  test::RevolutionFlow neck(test::dumbbell_profile(0.25, 401));
  advance(dumbbell, "mean-curvature", 0.03, 30);
  neck.advance_to(0.03);
  double narrowest = 1;
  for (const Vec3& p : dumbbell.positions)
    if (std::abs(p.z()) < 0.1) narrowest = std::min(narrowest, p.head<2>().norm());
  MESSAGE("necks ", narrowest, " and ", neck.radius(neck.neck()));
  CHECK(narrowest == Approx(neck.radius(neck.neck())).epsilon(0.02));
  CHECK(volume_of(dumbbell) == Approx(neck.volume()).epsilon(0.01));
}

TEST_CASE("steps a thousand times longer than explicit ones are stable") {
  for (const char* name : {"mean-curvature", "volume-preserving-curvature", "surface-diffusion"}) {
    CAPTURE(name);
    ShapeOptions options;
    options.kind = "sphere";
    options.faces = 3000;
    options.noise = 0.05;
    Mesh mesh = make_shape(options);
    const Box before = bounding_box(mesh);
    const double edge = shortest_edge(mesh);
    const bool is_fourth_order = std::string(name) == "surface-diffusion";
    const double limit = is_fourth_order ? std::pow(edge, 4) / 32 : edge * edge / 4;
    advance(mesh, name, 3 * 1000 * limit, 3);
    for (const Vec3& p : mesh.positions) REQUIRE(p.allFinite());
    CHECK(bounding_box(mesh).diagonal().norm() < 1.05 * before.diagonal().norm());
    // Mean-curvature flow would have made an exact sphere vanish before that time. The rest of the
    // mesh may be inside out.
    if (std::string(name) == "mean-curvature")
      CHECK(volume_of(mesh) > -1e-12);
    else
      CHECK(volume_of(mesh) > 0);
  }
}

TEST_CASE("at constant volume an ellipsoid becomes the sphere of its volume") {
  Mesh mesh = ellipsoid(0.7, 1, 4);
  const double before = volume_of(mesh);
  advance(mesh, "volume-preserving-curvature", 1, 100);
  CHECK(volume_of(mesh) == Approx(before).epsilon(1e-12));
  MESSAGE("spread of the radius: ", radius_spread(mesh));
  CHECK(radius_spread(mesh) < 0.005);
  CHECK(mean_radius(mesh) == Approx(std::cbrt(before * 3 / (4 * std::numbers::pi))).epsilon(0.005));
}

TEST_CASE("components keep their own volumes") {
  const Mesh small = test::moved(test::scaled(ellipsoid(0.7, 1, 3), 0.3), Vec3(5, 0, 0));
  Mesh mesh = test::joined(ellipsoid(0.7, 1, 3), small);
  const std::size_t faces = mesh.faces.size() / 2;
  const auto volumes = [&] {
    Mesh first = mesh, second = mesh;
    first.faces.resize(faces);
    second.faces.erase(second.faces.begin(), second.faces.begin() + static_cast<long>(faces));
    return std::pair(volume_of(first), volume_of(second));
  };
  const auto before = volumes();
  advance(mesh, "volume-preserving-curvature", 0.05, 10);
  advance(mesh, "surface-diffusion", 1e-5, 10);
  CHECK(volumes().first == Approx(before.first).epsilon(1e-12));
  CHECK(volumes().second == Approx(before.second).epsilon(1e-10));
}

TEST_CASE("surface diffusion damps waves on a sphere at the rate of the closed form") {
  // The radius is 1 + a P2(cos), where P2 is the Legendre polynomial of degree 2. The linearized
  // flow multiplies the amplitude a by exp(-24 t).
  const double start = 0.05;
  Mesh mesh = test::icosphere(4);
  for (Vec3& p : mesh.positions) p *= 1 + start * (3 * p.z() * p.z() - 1) / 2;
  const auto amplitude = [&] {
    double sum = 0, weight = 0;
    for (const Vec3& p : mesh.positions) {
      const double wave = (3 * std::pow(p.normalized().z(), 2) - 1) / 2;
      sum += (p.norm() - mean_radius(mesh)) * wave;
      weight += wave * wave;
    }
    return sum / weight;
  };
  const double before = amplitude(), volume_before = volume_of(mesh);
  advance(mesh, "surface-diffusion", 0.02, 80);
  MESSAGE("decay ", amplitude() / before, " and ", std::exp(-24 * 0.02));
  CHECK(amplitude() / before == Approx(std::exp(-24 * 0.02)).epsilon(0.05));
  CHECK(volume_of(mesh) == Approx(volume_before).epsilon(1e-12));
}

TEST_CASE("borders stay, and flows that keep the volume refuse open meshes") {
  Mesh mesh = test::grid(6);
  mesh.positions[24] += Vec3(0, 0, 0.2);
  const Mesh start = mesh;
  const Flow flow = make_flow("mean-curvature");
  const auto moved = flow.motion.displacement(mesh, {0, 1, 0}, Progress());
  CHECK(flow.counts->fixed == 24);
  for (std::size_t v = 0; v < moved.size(); ++v) {
    const Vec3& p = start.positions[v];
    if (p.x() == 0 || p.y() == 0 || p.x() == 1 || p.y() == 1) CHECK(moved[v] == Vec3::Zero());
  }
  CHECK(moved[24].z() < -0.15);
  for (const char* name : {"volume-preserving-curvature", "surface-diffusion"}) {
    const Motion closed_only = make_flow(name).motion;
    CHECK_THROWS_AS(closed_only.displacement(mesh, {0, 1, 0}, Progress()), InputError);
    CHECK_THROWS_AS(closed_only.velocity(mesh, {0, 0, 0}, Progress()), InputError);
  }
  CHECK_THROWS_AS(flow.motion.velocity(test::soup_of(test::cube()), {}, Progress()), InputError);
}

TEST_CASE("velocities are the limit of short steps") {
  const Mesh mesh = ellipsoid(0.7, 1, 3);
  for (const char* name : {"mean-curvature", "volume-preserving-curvature", "surface-diffusion"}) {
    CAPTURE(name);
    const Motion motion = make_flow(name, {.speed = 2}).motion;
    const auto velocities = motion.velocity(mesh, {}, Progress());
    const double span = 1e-11;
    const auto displacements = motion.displacement(mesh, {0, span, 0}, Progress());
    double worst = 0, largest = 0;
    for (std::size_t v = 0; v < velocities.size(); ++v) {
      worst = std::max(worst, (displacements[v] / span - velocities[v]).norm());
      largest = std::max(largest, velocities[v].norm());
    }
    CHECK(worst < 1e-3 * largest);
  }
}
