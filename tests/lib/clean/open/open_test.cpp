/// Open meshes (paper 4.6): the remaining parts of sheets, bowls and scans with holes, checked by
/// closed-form areas and by counts that share no code with the cleaning.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

using Map = std::function<Vec3(double, double)>;

// The square from -1 to 1 with 20 x 20 cells, mapped by a function.
Mesh sheet(const Map& map) {
  Mesh mesh = test::grid(20);
  for (Vec3& p : mesh.positions) p = map(2 * p[0] - 1, 2 * p[1] - 1);
  return mesh;
}

Vec3 flat(double x, double y) { return {x, y, 0}; }
Vec3 tilted(double x, double y) { return {x, 0.3 * y + 0.013, y + 0.1}; }
Vec3 wavy(double x, double y) { return {x, y, 0.2 * std::sin(5 * x) * std::cos(4 * y)}; }

// Returns the mesh without the faces that extend above the height.
Mesh without_top(Mesh mesh, double height) {
  std::vector<bool> keep;
  for (const Face& f : mesh.faces) {
    keep.push_back(
        std::all_of(f.begin(), f.end(), [&](Index v) { return mesh.positions[v][2] <= height; }));
  }
  return select_faces(mesh, keep);
}

// A surface with a waist at z = -0.1 so narrow that it passes through itself.
Mesh squeezed(Mesh mesh) {
  for (Vec3& p : mesh.positions) {
    const double height = (p[2] + 0.1) / 0.25;
    p[0] *= 1 - 1.3 * std::exp(-height * height);
  }
  return mesh;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const Face& f : mesh.faces) {
    const Vec3& a = mesh.positions[f[0]];
    sum += (mesh.positions[f[1]] - a).cross(mesh.positions[f[2]] - a).norm() / 2;
  }
  return sum;
}

void check_unchanged(const Mesh& mesh) {
  const CleanResult result = clean(mesh);
  CHECK(!result.changed);
  CHECK(result.mesh.positions == mesh.positions);
  CHECK(result.mesh.faces == mesh.faces);
}

// Checks the properties of every cleaned open mesh.
Mesh cleaned(const Mesh& mesh) {
  Mesh result = clean(mesh).mesh;
  CHECK(check_manifold(result).is_manifold());
  CHECK(check_manifold(result).is_oriented());
  CHECK(find_intersections(result).empty());
  check_unchanged(result);
  return result;
}

std::size_t component_count(const Mesh& mesh) {
  return connected_components(mesh).components.size();
}

Mesh random_sheet(test::Random& random) {
  const Vec3 origin = random.point(0, 3), u = random.point(-3, 3), v = random.point(-3, 3);
  Mesh bumpy = test::grid(3);
  for (Vec3& p : bumpy.positions) p = origin + p.x() * u + p.y() * v + random.point(-0.5, 0.5);
  return bumpy;
}

}  // namespace

TEST_CASE("a sheet that meets nothing stays, in either orientation") {
  for (const Map& map : {Map(flat), Map(wavy)}) {
    check_unchanged(sheet(map));
    check_unchanged(test::reversed(sheet(map)));
  }
  check_unchanged(without_top(test::icosphere(4), 0.6));
}

TEST_CASE("of two intersecting sheets the parts in front of both stay") {
  // The sheets intersect at y = -0.017. The flat one stays below this y; the tilted one stays where
  // its parameter y is above -0.1.
  const double steep = 2 * std::sqrt(1 + 0.3 * 0.3);
  const Mesh down = cleaned(test::joined(sheet(flat), sheet(tilted)));
  CHECK(area(down) == doctest::Approx(2 * (1 - 0.017) + steep * 1.1).epsilon(1e-9));
  CHECK(component_count(down) == 1);
  CHECK(check_manifold(down).boundary_loops == 1);

  const Mesh up = cleaned(test::joined(sheet(flat), test::reversed(sheet(tilted))));
  CHECK(area(up) == doctest::Approx(2 * (1 + 0.017) + steep * 1.1).epsilon(1e-9));
  CHECK(component_count(up) == 1);
}

TEST_CASE("a sheet that is pierced within keeps its area, and only the part before it is left") {
  const Mesh blade =
      sheet([](double x, double y) { return Vec3(0.4 * x + 0.01, 0.1 * y, 0.7 * y + 0.02); });
  const Mesh result = cleaned(test::joined(sheet(flat), blade));
  const double length = std::sqrt(0.1 * 0.1 + 0.7 * 0.7) * (1 + 0.02 / 0.7);
  CHECK(area(result) == doctest::Approx(4 + 0.8 * length).epsilon(1e-9));
  CHECK(component_count(result) == 2);
}

TEST_CASE("a sheet loses its part inside a ball, and the ball is only cut along the curve") {
  const Mesh ball = test::moved(test::icosphere(4), {0, 0, 0.017});
  const Mesh plane = sheet([](double x, double y) { return Vec3(2 * x, 2 * y, 0.003); });
  const Mesh result = cleaned(test::joined(plane, ball));
  const double disk = 1 - 0.014 * 0.014;
  CHECK(area(result) == doctest::Approx(16 - M_PI * disk + area(ball)).epsilon(0.001));
  CHECK(component_count(result) == 2);
  std::size_t closed = 0;
  for (const Component& c : connected_components(result).components)
    if (c.boundary_loops == 0 && ++closed == 1)
      CHECK(c.volume == doctest::Approx(volume(ball)).epsilon(1e-9));
  CHECK(closed == 1);
}

TEST_CASE("a ball and a body with a hole lose their parts inside each other") {
  const Mesh ball = test::moved(test::icosphere(4), {0.9, 0.02, 0.01});
  Mesh punctured = test::icosphere(4);
  const Mesh closed = cleaned(test::joined(punctured, ball));
  std::erase_if(punctured.faces,
                [&](const Face& f) { return punctured.positions[f[0]].x() < -0.95; });
  const double hole = area(test::icosphere(4)) - area(punctured);
  const Mesh result = cleaned(test::joined(punctured, ball));
  CHECK(hole > 0.1);
  CHECK(area(result) == doctest::Approx(area(closed) - hole).epsilon(1e-9));
  CHECK(component_count(result) == 1);
}

TEST_CASE("a sheet affects only surfaces that it meets") {
  const Mesh ball = test::icosphere(3);
  for (const double height : {-3.0, 3.0}) {
    const Mesh plane = sheet([&](double x, double y) { return Vec3(2 * x, 2 * y, height); });
    check_unchanged(test::joined(plane, ball));
    check_unchanged(test::joined(test::reversed(plane), ball));
  }
}

TEST_CASE("surfaces inside a closed body vanish; those that a body with a hole surrounds stay") {
  const Mesh ball = test::icosphere(3);
  const Mesh small_sheet = sheet([](double x, double y) { return Vec3(0.3 * x, 0.3 * y, 0.01); });
  CHECK(cleaned(test::joined(ball, small_sheet)).faces.size() == ball.faces.size());
  const Mesh scan = without_top(test::scaled(test::icosphere(4), 3), 2.7);
  check_unchanged(test::joined(scan, ball));
}

TEST_CASE("a bowl that passes through itself parts there and keeps its rim") {
  const Mesh bowl = without_top(test::icosphere(5), 0.6);
  const std::size_t rim = check_manifold(bowl).border_halfedges.size();
  const Mesh result = cleaned(squeezed(bowl));
  CHECK(component_count(result) == 2);
  CHECK(check_manifold(result).boundary_loops == 1);
  CHECK(check_manifold(result).border_halfedges.size() == rim);
}

TEST_CASE("a scan that is oriented inwards and meets nothing stays") {
  check_unchanged(test::reversed(without_top(test::icosphere(4), 0.9)));
}

TEST_CASE("the result of random intersecting sheets is clean") {
  test::Random random(3);
  for (int round = 0; round < 700; ++round) {
    Mesh mesh;
    for (int sheets = 0; sheets < 3; ++sheets) mesh = test::joined(mesh, random_sheet(random));
    cleaned(mesh);
  }
}

TEST_CASE("what is cut and removed is counted over all passes") {
  const auto corners_of = [](const Mesh& mesh) {
    std::multiset<std::array<double, 9>> corners;
    for (const Face& f : mesh.faces) {
      std::array<double, 9> entry{};
      for (std::size_t i = 0; i < 9; ++i) entry[i] = mesh.positions[f[i / 3]][i % 3];
      corners.insert(entry);
    }
    return corners;
  };
  test::Random random(3);
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    Mesh mesh;
    for (int sheets = 0; sheets < 3; ++sheets) mesh = test::joined(mesh, random_sheet(random));
    const CleanResult result = clean(mesh);
    const auto before = corners_of(mesh);
    std::size_t whole = 0;
    for (const auto& corners : corners_of(result.mesh)) whole += before.count(corners);
    CHECK(mesh.faces.size() == whole + result.cut_faces + result.removed_faces);
  }
}

TEST_CASE("static refuses an open mesh") {
  CleanOptions options;
  options.method = ExteriorMethod::static_test;
  CHECK_THROWS_AS(clean(sheet(flat), options), UsageError);
}

TEST_CASE("an inside-out patch is refused, even if it shares only positions with the rest") {
  for (const bool is_reversed : {false, true}) {
    CAPTURE(is_reversed);
    Mesh mesh = test::icosphere(2);
    std::vector<Index> copies(mesh.positions.size(), no_index);
    for (Face& f : mesh.faces) {
      const Vec3 sum = mesh.positions[f[0]] + mesh.positions[f[1]] + mesh.positions[f[2]];
      if (sum.z() < 1.5) continue;
      for (Index& v : f) {
        if (copies[v] == no_index) {
          copies[v] = static_cast<Index>(mesh.positions.size());
          mesh.positions.emplace_back(mesh.positions[v]);
        }
        v = copies[v];
      }
      if (is_reversed) std::swap(f[0], f[1]);
    }
    if (is_reversed) {
      CHECK_THROWS_AS(clean(mesh), InputError);
    } else {
      CHECK(clean(mesh).removed_faces == 0);
    }
  }
}
