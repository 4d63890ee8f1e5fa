#include "transformesh/remesh.h"

#include <cmath>
#include <numbers>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

RemeshOptions around(const Mesh& mesh, int iterations = 1) {
  RemeshOptions options;
  const double mean = edge_lengths(mesh).mean;
  options.min_edge = 0.7 * mean;
  options.max_edge = 1.5 * mean;
  options.iterations = iterations;
  return options;
}

/// A sphere with random vertices, and so with badly shaped triangles of all kinds.
Mesh bad_sphere(std::uint64_t seed, double jitter = 0.06) {
  Mesh mesh = icosphere(3);
  Random random(seed);
  for (Vec3& point : mesh.positions) point = (point + random.point(-jitter, jitter)).normalized();
  return mesh;
}

void check_sound(const Mesh& before, const Mesh& after) {
  CHECK(is_oriented_manifold(after));
  CHECK(is_closed(after) == is_closed(before));
  CHECK(euler_number(after) == euler_number(before));
  CHECK(connected_components(after).components.size() ==
        connected_components(before).components.size());
  CHECK(find_intersections(after).empty());
}

template <class Error>
std::string message_of(Mesh mesh, const RemeshOptions& options) {
  try {
    remesh(mesh, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a bad mesh becomes a good one") {
  Mesh mesh = bad_sphere(1);
  REQUIRE(angles(mesh).minimum_deg < 10);
  const Mesh before = mesh;
  const RemeshResult result = remesh(mesh, around(mesh, 5));
  check_sound(before, mesh);
  CHECK(angles(mesh).minimum_deg > 25);
  CHECK(angles(mesh).minimum_mean_deg > 50);
  CHECK(result.degenerate_faces == 0);
  CHECK(result.collapses > 0);
  CHECK(result.flips > 0);
}

TEST_CASE("three quarters of the vertices of bad meshes come to have six neighbors") {
  // the last digits of a single mesh change the result by a few hundredths
  constexpr int count = 20;
  double sum = 0;
  for (int seed = 1; seed <= count; ++seed) {
    Mesh mesh = bad_sphere(seed);
    remesh(mesh, around(mesh, 5));
    sum += valence_six_share(mesh);
  }
  CHECK(sum / count > 0.76);
}

TEST_CASE("edge lengths are brought into the interval") {
  Mesh mesh = icosphere(3);
  RemeshOptions options = around(mesh, 6);
  SUBCASE("finer") { options.min_edge /= 2, options.max_edge /= 2; }
  SUBCASE("coarser") { options.min_edge *= 2, options.max_edge *= 2; }
  const RemeshResult result = remesh(mesh, options);
  const EdgeLengths lengths = edge_lengths(mesh);
  CHECK(lengths.maximum <= options.max_edge * 1.1);
  CHECK(lengths.minimum >= options.min_edge * 0.85);
  CHECK(result.splits + result.collapses > 100);
}

TEST_CASE("edges become eight times as long in one iteration") {
  // sheets near each other stay apart at all stages
  Mesh mesh = joined(icosphere(5), scaled(reversed(icosphere(5)), 0.9));
  const Mesh before = mesh;
  RemeshOptions options = around(mesh, 1);
  options.min_edge *= 8;
  options.max_edge *= 8;
  remesh(mesh, options);
  check_sound(before, mesh);
  CHECK(mesh.faces.size() < before.faces.size() / 40);
  CHECK(edge_lengths(mesh).maximum < 1.2 * options.max_edge);
  CHECK(angles(mesh).minimum_deg > 20);
  CHECK(std::abs(volume(mesh) / volume(before) - 1) < 0.02);
}

TEST_CASE("if edges become eight times as long, few stay short") {
  Mesh mesh = icosphere(5);
  RemeshOptions options = around(mesh, 1);
  options.min_edge *= 8;
  options.max_edge *= 8;
  // rotated spheres have other last digits, which change the shortest edge
  constexpr int count = 8;
  double sum = 0;
  Random random(1);
  for (int i = 0; i < count; ++i) {
    Mesh turned = mesh;
    const Vec3 axis = random.point(-1, 1).normalized();
    for (Vec3& p : turned.positions) p = 2 * axis.dot(p) * axis - p;
    remesh(turned, options);
    sum += edge_lengths(turned).minimum / options.min_edge;
  }
  CHECK(sum / count > 0.8);
}

TEST_CASE("the volume of a sphere stays within a thousandth per pass") {
  Mesh mesh = icosphere(4);
  const double before = volume(mesh);
  SUBCASE("as it is") { remesh(mesh, around(mesh)); }
  SUBCASE("finer") {
    RemeshOptions options = around(mesh);
    options.min_edge *= 0.6;
    options.max_edge *= 0.6;
    remesh(mesh, options);
  }
  SUBCASE("coarser") {
    RemeshOptions options = around(mesh);
    options.min_edge *= 1.5;
    options.max_edge *= 1.5;
    remesh(mesh, options);
  }
  CHECK(std::abs(volume(mesh) / before - 1) < 1e-3);
}

TEST_CASE("a mesh at rest is left nearly alone") {
  Mesh mesh = bad_sphere(2);
  const RemeshOptions options = around(mesh, 20);
  remesh(mesh, options);
  RemeshOptions once = options;
  once.iterations = 1;
  const RemeshResult result = remesh(mesh, once);
  CHECK(result.splits + result.collapses + result.flips < mesh.faces.size() / 100);
}

TEST_CASE("twenty random meshes of several kinds stay what they are") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Mesh shapes[] = {bad_sphere(seed, 0.03), torus(1, 0.3, 24, 9), grid(12),
                           joined(icosphere(2), moved(icosphere(2), {2.2, 0, 0}))};
    Mesh mesh = shapes[seed % 4];
    const double noise = 0.1 * edge_lengths(mesh).mean;
    for (Vec3& point : mesh.positions) point += random.point(-noise, noise);
    const Mesh before = mesh;
    CAPTURE(seed);
    REQUIRE(find_intersections(before).empty());
    RemeshOptions options = around(mesh, 3);
    options.min_edge *= random.uniform(0.5, 1.2);
    options.max_edge = options.min_edge * random.uniform(1.5, 3);
    options.flip = seed % 3 == 0 ? FlipRule::angle : FlipRule::valence;
    options.smoothing = static_cast<Smoothing>(random.below(4));
    options.smooth_first = random.uniform(0, 1);
    options.smooth_second =
        random.uniform((options.smooth_first - 1) / 2, options.smooth_first / 2);
    options.feature_angle_deg = seed % 2 ? 180 : 60;
    options.keep_border = seed % 8 == 2;
    remesh(mesh, options);
    check_sound(before, mesh);
  }
}

TEST_CASE("attributes stay in their places") {
  Mesh mesh = bad_sphere(3);
  Column& x = mesh.vertex_columns.get("x_copy", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) x.values[v] = mesh.positions[v].x();
  Column& side = mesh.face_columns.get("side", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    side.values[f] = mesh.positions[mesh.faces[f][0]].x() > 0;
  }
  const double edge = edge_lengths(mesh).mean;
  remesh(mesh, around(mesh, 5));

  const Column& after = *mesh.vertex_columns.find("x_copy");
  REQUIRE(after.values.size() == mesh.positions.size());
  double largest = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    largest = std::max(largest, std::abs(after.values[v] - mesh.positions[v].x()));
  }
  CHECK(largest < 0.15 * edge);
  const Column& sides = *mesh.face_columns.find("side");
  REQUIRE(sides.values.size() == mesh.faces.size());
  std::size_t strayed = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const double at = mesh.positions[mesh.faces[f][0]].x();
    if (std::abs(at) > 4 * edge) strayed += (at > 0) != (sides.values[f] == 1);
  }
  CHECK(strayed == 0);
}

TEST_CASE("survivors keep their order") {
  Mesh mesh = bad_sphere(4);
  Column& id = mesh.vertex_columns.get("id", Scalar::int32, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) id.values[v] = static_cast<double>(v);
  RemeshOptions options = around(mesh);
  options.max_edge = 10;  // no new vertices
  remesh(mesh, options);
  const std::vector<double>& ids = mesh.vertex_columns.find("id")->values;
  // a merged vertex keeps its index, whichever end gave its `id`
  std::size_t descents = 0;
  for (std::size_t v = 1; v < ids.size(); ++v) descents += ids[v] < ids[v - 1];
  CHECK(ids.size() < 642);
  CHECK(descents < ids.size() / 5);
}

TEST_CASE("sheets close to each other never meet") {
  // a thin plate, and two spheres a tenth of an edge apart
  const auto check = [](Mesh mesh, double factor) {
    RemeshOptions options = around(mesh, 3);
    options.min_edge *= factor;
    options.max_edge *= factor;
    const Mesh before = mesh;
    remesh(mesh, options);
    CHECK(find_intersections(mesh).empty());
    check_sound(before, mesh);
  };
  Mesh plate = icosphere(4);
  for (Vec3& point : plate.positions) point.z() *= 0.01;
  const Mesh spheres = joined(icosphere(4), moved(icosphere(4), {2.005, 0, 0}));
  const Mesh nested = joined(icosphere(4), scaled(reversed(icosphere(4)), 0.99));
  const Mesh same_way = joined(icosphere(3), scaled(icosphere(3), 0.997));
  for (const double factor : {0.7, 1.3, 2.5}) {
    CAPTURE(factor);
    check(plate, factor);
    check(spheres, factor);
    check(nested, factor);
    check(same_way, factor);
  }
}

TEST_CASE("small components go at once, and nothing left is an error") {
  const Mesh speck = moved(scaled(icosphere(1), 0.01), {3, 0, 0});
  Mesh mesh = joined(icosphere(3), speck);
  const RemeshResult result = remesh(mesh, around(icosphere(3)));
  CHECK(result.components_removed.count == 1);
  CHECK(connected_components(mesh).components.size() == 1);

  RemeshOptions coarse;
  coarse.min_edge = 5;
  coarse.max_edge = 10;
  CHECK(message_of<GoalError>(icosphere(1), coarse).starts_with("the only component is smaller"));
  CHECK(message_of<GoalError>(icosphere(1), coarse).find("nothing would be left") !=
        std::string::npos);
}

TEST_CASE("a small film of large volume stays") {
  // edges of 0.28 but a volume of four: above pi/6 e1^3 for e1 = 0.3
  Mesh mesh = icosphere(2);
  RemeshOptions options;
  options.min_edge = 0.35;
  options.max_edge = 0.8;
  options.iterations = 0;
  REQUIRE(edge_lengths(mesh).maximum < 0.35);
  CHECK(remesh(mesh, options).components_removed.count == 0);
}

TEST_CASE("a thin plate that is wider than the shortest edge stays") {
  // edges of 0.14 and a volume of .002, below pi/6 e1^3 = .0042 for e1 = 0.2
  Mesh plate = icosphere(3);
  for (Vec3& p : plate.positions) p = {0.5 * p.x(), 0.5 * p.y(), 0.001 * p.z()};
  RemeshOptions options;
  options.min_edge = 0.2;
  options.max_edge = 0.4;
  REQUIRE(edge_lengths(plate).maximum < options.min_edge);
  REQUIRE(signed_volume(plate) < std::numbers::pi / 6 * std::pow(options.min_edge, 3));
  Mesh mesh = joined(icosphere(3), moved(plate, {3, 0, 0}));
  CHECK(remesh(mesh, options).components_removed.count == 0);
  CHECK(connected_components(mesh).components.size() == 2);
}

TEST_CASE("what is removed is reported with its faces, area and volume") {
  const Mesh thread = [] {
    Mesh mesh = icosphere(2);
    for (Vec3& p : mesh.positions) p = {0.3 * p.x(), 0.01 * p.y(), 0.01 * p.z()};
    return mesh;
  }();
  RemeshOptions options;
  options.min_edge = 0.2;
  options.max_edge = 0.4;
  options.iterations = 0;
  Mesh mesh = joined(icosphere(3), moved(thread, {3, 0, 0}));
  const RemeshResult::RemovedComponents removed = remesh(mesh, options).components_removed;
  CHECK(removed.count == 1);
  CHECK(removed.faces == thread.faces.size());
  CHECK(removed.area == doctest::Approx(surface_area(thread)));
  CHECK(removed.volume == doctest::Approx(signed_volume(thread)));
}

TEST_CASE("triangles without area go") {
  Mesh mesh = icosphere(2);
  // a cap: the apex of face 10 lies in the middle of the opposite edge
  const Face face = mesh.faces[10];
  const Index apex = face[0];
  mesh.positions[apex] = 0.5 * (mesh.positions[face[1]] + mesh.positions[face[2]]);
  REQUIRE(face_area(mesh, 10) == doctest::Approx(0));
  const Mesh before = mesh;
  const RemeshResult result = remesh(mesh, around(mesh, 2));
  CHECK(result.degenerate_faces == 0);
  CHECK(angles(mesh).minimum_deg > 5);
  CHECK(is_oriented_manifold(mesh));
  CHECK(euler_number(mesh) == euler_number(before));
}

TEST_CASE("borders stay where they are") {
  Mesh mesh = grid(10);
  Random random(5);
  for (Vec3& point : mesh.positions) {
    const bool inside = point.x() > 0 && point.x() < 1 && point.y() > 0 && point.y() < 1;
    if (inside) point += Vec3(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), 0);
  }
  RemeshOptions options = around(mesh, 4);
  SUBCASE("as a shape") {
    remesh(mesh, options);
    CHECK(surface_area(mesh) == doctest::Approx(1));
  }
  SUBCASE("exactly, with keep_border") {
    options.keep_border = true;
    options.min_edge = 0.15;
    options.max_edge = 0.3;
    remesh(mesh, options);
    CHECK(surface_area(mesh) == doctest::Approx(1));
    std::size_t on_border = 0;
    for (const Vec3& p : mesh.positions) {
      on_border += p.x() == 0 || p.x() == 1 || p.y() == 0 || p.y() == 1;
    }
    CHECK(on_border == 40);
  }
}

TEST_CASE("sharp edges stay sharp") {
  Mesh mesh = cube();
  RemeshOptions options;
  options.min_edge = 0.07;
  options.max_edge = 0.15;
  options.iterations = 5;
  options.feature_angle_deg = 45;
  remesh(mesh, options);
  CHECK(volume(mesh) == doctest::Approx(1));
  CHECK(surface_area(mesh) == doctest::Approx(6));
  CHECK(mesh.faces.size() > 500);
  CHECK(angles(mesh).minimum_deg > 20);
}

TEST_CASE("for float output all positions are floats") {
  Mesh mesh = bad_sphere(6);
  for (Vec3& p : mesh.positions) {
    for (double& x : p) x = round_to_single(x);
  }
  RemeshOptions options = around(mesh, 2);
  options.coordinate = Scalar::float32;
  remesh(mesh, options);
  std::size_t others = 0;
  for (const Vec3& p : mesh.positions) {
    for (const double x : p) others += x != round_to_single(x);
  }
  CHECK(others == 0);
}

TEST_CASE("the same input gives the same mesh") {
  Mesh first = bad_sphere(7);
  Mesh second = first;
  remesh(first, around(first, 3));
  remesh(second, around(bad_sphere(7), 3));
  CHECK(is_same(first, second));
}

TEST_CASE("options that make no sense are refused with numbers") {
  const Mesh sphere = icosphere(1);
  RemeshOptions options = around(sphere);
  options.max_edge = 1.2 * options.min_edge;
  CHECK(message_of<UsageError>(sphere, options).find("1.5 times") != std::string::npos);
  options = around(sphere);
  options.min_edge = 0;
  CHECK(message_of<UsageError>(sphere, options).find("positive") != std::string::npos);
  options = around(sphere);
  options.min_edge = 1e-9;
  options.max_edge = 1e-8;
  CHECK(message_of<UsageError>(sphere, options).find("million faces") != std::string::npos);
  options = around(sphere);
  options.smoothing = Smoothing::bilaplace;
  options.smooth_first = 0.1;
  options.smooth_second = 0.2;
  CHECK(message_of<UsageError>(sphere, options).find("between -0.45 and 0.05") !=
        std::string::npos);
  CHECK(message_of<InputError>(Mesh{}, around(sphere)).find("no faces") != std::string::npos);
  // A double cannot represent the number of faces.
  options = around(sphere);
  options.min_edge = 1e-300;
  options.max_edge = 1e-200;
  CHECK(message_of<UsageError>(sphere, options).find("500 million faces") != std::string::npos);
}

TEST_CASE("a mesh too large for areas is refused, whatever its edges") {
  for (const double scale : {1e76, 1e100, 1e154, 1e300}) {
    CAPTURE(scale);
    Mesh sphere = icosphere(1);
    for (Vec3& position : sphere.positions) position *= scale;
    CHECK(message_of<InputError>(sphere, around(sphere)).find("too large") != std::string::npos);
  }
  Mesh sphere = icosphere(2);
  for (Vec3& position : sphere.positions) position *= 4e74;
  CHECK(message_of<InputError>(sphere, around(sphere)).empty());
}
