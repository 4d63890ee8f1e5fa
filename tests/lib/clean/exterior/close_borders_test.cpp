/// Fans that close borders: with the faces they are a closed surface, whose winding number is
/// known.
#include "clean/exterior/close_borders.h"

#include <doctest/doctest.h>

#include <map>

#include "clean/open/borders.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"

namespace transformesh {
namespace {

BorderClosure closure_of(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  return close_borders(welded, find_borders(welded, mesh).loops);
}

/// The mesh together with what closes it.
Mesh closed(Mesh mesh, const BorderClosure& closure) {
  for (const Triangle& t : closure.triangles) {
    const auto base = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), t.begin(), t.end());
    mesh.faces.push_back({base, base + 1, base + 2});
  }
  return mesh;
}

/// By positions: whether along every edge as many faces run one way as the other.
bool is_closed(const Mesh& mesh) {
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, int> sums;
  const auto at = [&](Index v) {
    const Vec3& p = mesh.positions[v];
    return Point{p.x(), p.y(), p.z()};
  };
  for (const Face& f : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = at(f[i]), b = at(f[(i + 1) % 3]);
      sums[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second == 0; });
}

/// A ball without its faces above that height.
Mesh bowl(double height) {
  Mesh mesh = test::icosphere(3);
  std::erase_if(mesh.faces, [&](const Face& f) {
    return std::any_of(f.begin(), f.end(), [&](Index v) { return mesh.positions[v].z() > height; });
  });
  return mesh;
}

}  // namespace

TEST_CASE("a closure does not depend on the unit of length") {
  const auto count_in_sheet = [](const BorderClosure& closure) {
    return std::count(closure.in_sheet.begin(), closure.in_sheet.end(), 1);
  };
  for (const Mesh& mesh : {bowl(0.6), bowl(-0.9), test::grid(5)}) {
    const BorderClosure usual = closure_of(mesh);
    for (const double scale : {1e-300, 1e-155, 1e100, 1e155, 1e200, 1e300}) {
      const Mesh scaled = test::scaled(mesh, scale);
      const BorderClosure closure = closure_of(scaled);
      CHECK(count_in_sheet(closure) == count_in_sheet(usual));
      REQUIRE(closure.triangles.size() == usual.triangles.size());
      for (std::size_t i = 0; i < usual.triangles.size(); ++i)
        CHECK((closure.triangles[i][2] / scale - usual.triangles[i][2]).norm() < 1e-9);
    }
  }
}

TEST_CASE("a closed mesh has an empty closure") {
  CHECK(closure_of(test::cube()).empty());
  CHECK(closure_of(test::cube()).in_sheet.empty());
}

TEST_CASE("a body with a hole is closed across it, and encloses what the body does") {
  for (const double height : {0.95, 0.7, 0.3}) {
    CAPTURE(height);
    const Mesh mesh = bowl(height);
    const BorderClosure closure = closure_of(mesh);
    const Mesh whole = closed(mesh, closure);
    CHECK(is_closed(whole));
    CHECK(std::count(closure.in_sheet.begin(), closure.in_sheet.end(), 1) == 0);
    // A cap of height h lacks pi h^2 (3 - h) / 3; the mesh lies within the ball by some percent.
    const double h = 1 - height;
    const double ball = 4 * std::numbers::pi / 3;
    const double expected = ball - std::numbers::pi * h * h * (3 - h) / 3;
    CHECK(test::signed_volume(whole) == doctest::Approx(expected).epsilon(0.06));
    CHECK(test::winding_number(whole, {0, 0, -0.5}) == doctest::Approx(1));
    CHECK(test::winding_number(whole, {0, 0, 1.2}) == doctest::Approx(0));
  }
}

TEST_CASE("a sheet is closed from far behind, so that all its faces look outwards") {
  test::Random random(3);
  Mesh bumpy = test::grid(10);
  for (Vec3& p : bumpy.positions) p.z() = random.uniform(-0.05, 0.05);
  for (const bool is_reversed : {false, true}) {
    const Mesh mesh = is_reversed ? test::reversed(bumpy) : bumpy;
    const BorderClosure closure = closure_of(mesh);
    CHECK(closure.triangles.size() == 40);
    CHECK(std::count(closure.in_sheet.begin(), closure.in_sheet.end(), 1) == 200);
    const Mesh whole = closed(mesh, closure);
    CHECK(is_closed(whole));
    const double front = is_reversed ? -0.5 : 0.5;
    CHECK(test::winding_number(whole, {0.5, 0.5, front}) == doctest::Approx(0));
    CHECK(test::winding_number(whole, {0.5, 0.5, -front}) == doctest::Approx(1));
    CHECK(test::winding_number(whole, {0.5, 0.5, -10 * front}) == doctest::Approx(1));
  }
}

TEST_CASE("every triangle names a face of the component that it closes") {
  const Mesh body = bowl(0.7), sheet = test::moved(test::grid(4), {5, 0, 0});
  const Mesh mesh = test::joined(body, sheet);
  const BorderClosure closure = closure_of(mesh);
  REQUIRE(closure.face_of.size() == closure.triangles.size());
  std::size_t of_sheet = 0;
  for (std::size_t i = 0; i < closure.face_of.size(); ++i) {
    const bool is_of_sheet = closure.face_of[i] >= body.faces.size();
    CHECK(is_of_sheet == (closure.triangles[i][0].x() > 2));
    CHECK((closure.in_sheet[closure.face_of[i]] == 1) == is_of_sheet);
    of_sheet += is_of_sheet ? 1 : 0;
  }
  CHECK(of_sheet == 16);
  CHECK(is_closed(closed(mesh, closure)));
}

}  // namespace transformesh
