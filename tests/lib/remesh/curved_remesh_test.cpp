// Remeshing of surfaces that a flow carries: which vertices it moves, and how much of the shape it
// loses.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "helpers/cgal_oracle.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

constexpr double pi = 3.14159265358979323846;

RemeshOptions edges_around(double length, RemeshOptions options) {
  options.min_edge = 0.7 * length;
  options.max_edge = 1.5 * length;
  return options;
}

struct ByCoordinates {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};
using Places = std::set<Vec3, ByCoordinates>;

Places places_of(const Mesh& mesh) { return {mesh.positions.begin(), mesh.positions.end()}; }

/// The deformation test of Enright, Fedkiw, Ferziger & Mitchell, "A hybrid particle level set
/// method for improved interface capturing", Journal of Computational Physics 2002. The flow
/// reverses after half of the time.
Vec3 vortex(const Vec3& p, double time) {
  const auto square = [](double x) { return std::sin(pi * x) * std::sin(pi * x); };
  const auto sine = [](double x) { return std::sin(2 * pi * x); };
  return std::cos(pi * time) * Vec3(2 * square(p.x()) * sine(p.y()) * sine(p.z()),
                                    -sine(p.x()) * square(p.y()) * sine(p.z()),
                                    -sine(p.x()) * sine(p.y()) * square(p.z()));
}

Vec3 carried(const Vec3& p, double time, double span) {
  const Vec3 a = vortex(p, time);
  const Vec3 b = vortex(p + span / 2 * a, time + span / 2);
  const Vec3 c = vortex(p + span / 2 * b, time + span / 2);
  const Vec3 d = vortex(p + span * c, time + span);
  return p + span / 6 * (a + 2 * b + 2 * c + d);
}

/// Returns the fraction of its volume that a sphere has lost or gained at the end.
double lost_in_vortex(const RemeshOptions& options) {
  constexpr int steps = 40;
  Mesh mesh = icosphere(3);
  for (Vec3& p : mesh.positions) p = Vec3::Constant(0.35) + 0.15 * p;
  const double before = volume(mesh);
  const RemeshOptions all = edges_around(edge_lengths(mesh).mean, options);
  for (int step = 0; step < steps; ++step) {
    for (Vec3& p : mesh.positions) p = carried(p, 1.0 * step / steps, 1.0 / steps);
    remesh(mesh, all);
  }
  CHECK(count_self_intersections(mesh) == 0);
  CHECK(euler_number(mesh) == 2);
  return std::abs(volume(mesh) / before - 1);
}

}  // namespace

TEST_CASE("vertices that no step touches stay, to the last bit") {
  const Mesh sphere = icosphere(4);
  Mesh mesh = sphere;
  const RemeshResult still = remesh(mesh, edges_around(0.07, curved_remeshing()));
  CHECK(still.splits + still.collapses == 0);
  CHECK(mesh.positions == sphere.positions);

  Mesh dented = sphere;
  for (Vec3& p : dented.positions) p.z() *= p.z() > 0 ? 2.5 : 1;
  const Places before = places_of(dented);
  mesh = dented;
  const RemeshResult result = remesh(mesh, edges_around(0.07, curved_remeshing()));
  CHECK(result.splits > 500);
  const auto strangers = std::count_if(mesh.positions.begin(), mesh.positions.end(),
                                       [&](const Vec3& p) { return before.count(p) == 0; });
  CHECK(static_cast<std::size_t>(strangers) <= result.splits + result.collapses);
}

TEST_CASE("finer and coarser, a sphere stays round, without self-intersections") {
  for (const double length : {0.03, 0.12}) {
    CAPTURE(length);
    Mesh mesh = icosphere(4);
    for (int i = 0; i < 3; ++i) remesh(mesh, edges_around(length, curved_remeshing()));
    double farthest = 0;
    for (const Vec3& p : mesh.positions) farthest = std::max(farthest, std::abs(p.norm() - 1));
    CHECK(farthest < 1e-4);  // midpoints of the input's edges are 6e-4 inside the sphere
    CHECK(count_self_intersections(mesh) == 0);
    CHECK(is_oriented_manifold(mesh));
    CHECK(is_closed(mesh));
  }
}

TEST_CASE("a box keeps edges and corners without any feature angle") {
  RemeshOptions options = edges_around(0.2, curved_remeshing());
  Mesh mesh = cuboid(Vec3(0, 0, 0), Vec3(1, 0.8, 0.6));
  remesh(mesh, options);
  options = edges_around(0.3, curved_remeshing());
  for (int i = 0; i < 20; ++i) remesh(mesh, options);
  CHECK(volume(mesh) == doctest::Approx(0.48).epsilon(1e-12));
  CHECK(surface_area(mesh) == doctest::Approx(2 * (0.8 + 0.6 + 0.48)).epsilon(1e-12));
}

TEST_CASE("a sphere in a vortex and back loses less than a third of what it lost") {
  const double before = lost_in_vortex(RemeshOptions());
  const double after = lost_in_vortex(curved_remeshing());
  CHECK(before > 2e-3);
  CHECK(after < before / 3);
}

TEST_CASE("sliding on curves keeps a sphere rounder than sliding in planes") {
  RemeshOptions options = edges_around(0.07, RemeshOptions());
  const auto unevenness = [&] {
    Mesh mesh = icosphere(4);
    for (Vec3& p : mesh.positions) p = (p + 0.02 * Vec3(std::sin(40 * p.y()), 0, 0)).normalized();
    for (int i = 0; i < 5; ++i) remesh(mesh, options);
    double farthest = 0;
    for (const Vec3& p : mesh.positions) farthest = std::max(farthest, std::abs(p.norm() - 1));
    return farthest;
  };
  const double in_planes = unevenness();
  options.curved = true;
  CHECK(unevenness() < in_planes / 2);
}

TEST_CASE("films thicker than min_film stay, thinner ones may go") {
  // A plate of thickness 0.02 with edges of 0.1 has short edges only around its rim.
  Mesh plate = cuboid(Vec3(0, 0, 0), Vec3(1, 1, 0.02));
  RemeshOptions finer = edges_around(0.1, curved_remeshing());
  finer.min_edge = 0.01;
  finer.min_film = 0.001;
  remesh(plate, finer);
  CHECK(volume(plate) == doctest::Approx(0.02).epsilon(1e-9));

  RemeshOptions options = edges_around(0.1, RemeshOptions());
  options.smoothing = Smoothing::none;
  Mesh without = plate;
  remesh(without, options);
  CHECK(volume(without) < 0.97 * 0.02);

  options.min_film = 0.015;
  Mesh kept = plate;
  const RemeshResult result = remesh(kept, options);
  CHECK(result.films_kept > 0);
  CHECK(volume(kept) == doctest::Approx(0.02).epsilon(2e-3));

  options.min_film = 0.05;
  Mesh thinner = plate;
  remesh(thinner, options);
  CHECK(volume(thinner) < 0.97 * 0.02);
}

TEST_CASE("components wider than min_film are no remains") {
  RemeshOptions options = edges_around(1, curved_remeshing());
  const Mesh drop = scaled(icosphere(2), 0.1);
  Mesh mesh = joined(icosphere(2), moved(drop, Vec3(3, 0, 0)));
  CHECK(remesh(mesh, options).components_removed.count == 1);

  options.min_film = 0.1;
  mesh = joined(icosphere(2), moved(drop, Vec3(3, 0, 0)));
  CHECK(remesh(mesh, options).components_removed.count == 0);
}
