/// The laws of docs/design/open-meshes.md on random meshes. Surfaces are compared as sets of
/// triangles.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/select.h"

using namespace transformesh;

namespace {

using Corners = std::array<double, 9>;

/// Returns the triangles of a mesh, sorted, each beginning with its smallest corner.
std::vector<Corners> triangles(const Mesh& mesh) {
  std::vector<Corners> result;
  for (const Face& face : mesh.faces) {
    std::array<std::array<double, 3>, 3> t;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        t[i][k] = mesh.positions[face[i]][static_cast<Eigen::Index>(k)];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    Corners corners;
    for (std::size_t i = 0; i < 9; ++i) corners[i] = t[i / 3][i % 3] + 0.0;
    result.push_back(corners);
  }
  std::sort(result.begin(), result.end());
  return result;
}

Mesh shuffled(const Mesh& mesh, test::Random& random) {
  Mesh result = mesh;
  for (std::size_t i = result.faces.size(); i > 1; --i)
    std::swap(result.faces[i - 1], result.faces[random.below(i)]);
  return result;
}

Mesh without_some_faces(Mesh mesh, std::uint64_t percent, test::Random& random) {
  std::erase_if(mesh.faces, [&](const Face&) { return random.below(100) < percent; });
  return mesh;
}

Mesh ribbon(test::Random& random) {
  Mesh mesh = test::grid(4);
  const Vec3 origin = random.point(-1, 1), u = random.point(-2, 2), v = random.point(-0.1, 0.1);
  for (Vec3& p : mesh.positions) p = origin + p.x() * u + p.y() * v;
  return mesh;
}

Mesh bumpy_sheet(test::Random& random) {
  Mesh mesh = test::grid(4);
  const Vec3 origin = random.point(-2, 0), u = random.point(-3, 3), v = random.point(-3, 3);
  for (Vec3& p : mesh.positions) p = origin + p.x() * u + p.y() * v + random.point(-0.2, 0.2);
  return mesh;
}

Mesh ball(test::Random& random) {
  return test::moved(test::scaled(test::icosphere(1), random.uniform(0.4, 1.2)),
                     random.point(-1, 1));
}

/// A closed part that may intersect itself, and open components of a kind of random_case().
struct Case {
  Mesh closed, open;
  bool has_bodies = false;  ///< open components can be bodies with holes
  Mesh all() const { return test::joined(closed, open); }
};

Case random_case(std::uint64_t kind, test::Random& random) {
  Case result;
  result.has_bodies = kind == 3;
  if (kind != 1)
    for (std::uint64_t i = random.below(3); i > 0; --i)
      result.closed = test::joined(result.closed, ball(random));
  for (std::uint64_t i = 1 + random.below(2); i > 0; --i) {
    const Mesh added = kind < 2    ? bumpy_sheet(random)
                       : kind == 2 ? ribbon(random)
                                   : without_some_faces(ball(random), 5 + random.below(26), random);
    result.open = test::joined(result.open, added);
  }
  return result;
}

/// Returns the cleaned mesh, or nothing if it is refused.
std::optional<Mesh> cleaned(const Mesh& mesh) {
  try {
    return clean(mesh).mesh;
  } catch (const Error&) {
    return std::nullopt;
  }
}

constexpr std::uint64_t kinds = 4;

int rounds() {
  const char* wanted = std::getenv("TM_ROUNDS");
  return wanted == nullptr ? 60 : std::atoi(wanted);
}

template <class Test>
void for_each_case(const Test& test) {
  test::Random random(17);
  for (int round = 0; round < rounds(); ++round)
    for (std::uint64_t kind = 0; kind < kinds; ++kind) {
      CAPTURE(round);
      CAPTURE(kind);
      test(random_case(kind, random), random);
    }
}

}  // namespace

TEST_CASE("law 1: the result does not depend on the order of the faces") {
  for_each_case([](const Case& c, test::Random& random) {
    const auto before = cleaned(c.all()), after = cleaned(shuffled(c.all(), random));
    REQUIRE(before.has_value() == after.has_value());
    if (before) CHECK(triangles(*before) == triangles(*after));
  });
}

TEST_CASE("law 1: the result turns and grows with the mesh") {
  for_each_case([](const Case& c, test::Random&) {
    const auto turned = [](Mesh mesh) {
      for (Vec3& p : mesh.positions) p = Vec3(-2 * p.y(), 2 * p.x(), 2 * p.z());
      return mesh;
    };
    const auto before = cleaned(c.all()), after = cleaned(turned(c.all()));
    REQUIRE(before.has_value() == after.has_value());
    if (before) CHECK(surface_area(*after) == doctest::Approx(4 * surface_area(*before)));
  });
}

TEST_CASE("law 1: the result moves with the mesh") {
  for_each_case([](const Case& c, test::Random&) {
    // Coordinates are on a grid, so that the translation is exact.
    const auto moved = [](Mesh mesh, double distance) {
      for (Vec3& p : mesh.positions)
        for (double& x : p) x = std::round(std::ldexp(x, 20)) / std::ldexp(1, 20) + distance;
      return mesh;
    };
    const auto before = cleaned(moved(c.all(), 0)), after = cleaned(moved(c.all(), 16));
    REQUIRE(before.has_value() == after.has_value());
    if (before) CHECK(surface_area(*after) == doctest::Approx(surface_area(*before)));
  });
}

TEST_CASE("law 2: sheets that meet nothing stay as they are") {
  for_each_case([](const Case& c, test::Random&) {
    if (c.open.faces.empty() || !find_intersections(c.open).empty()) return;
    const CleanResult result = clean(c.open);
    CHECK(triangles(result.mesh) == triangles(c.open));
    // Only vertices at which umbrellas touch are duplicated.
    CHECK(result.changed == !check_manifold(c.open).is_manifold());
  });
}

TEST_CASE("laws 3 and 4: sheets only cut the boundary of the closed part") {
  for_each_case([](const Case& c, test::Random&) {
    if (c.closed.faces.empty()) return;
    Mesh all = c.all();
    Column& open = all.face_columns.get("open", Scalar::int32, all.faces.size());
    for (std::size_t f = 0; f < all.faces.size(); ++f)
      open.values[f] = f < c.closed.faces.size() ? 0 : 1;
    const auto alone = cleaned(c.closed), together = cleaned(all);
    if (!alone || !together) return;
    const Column& column = *together->face_columns.find("open");
    Mesh of_closed = *together, of_open = *together;
    for (Mesh* part : {&of_closed, &of_open}) part->faces.clear();
    for (std::size_t f = 0; f < together->faces.size(); ++f)
      (column.values[f] == 0 ? of_closed : of_open).faces.push_back(together->faces[f]);
    const double expected = surface_area(*alone);
    CHECK(surface_area(of_closed) <= expected * (1 + 1e-9));
    if (!c.has_bodies) CHECK(surface_area(of_closed) == doctest::Approx(expected).epsilon(1e-9));
    CHECK(surface_area(of_open) <= surface_area(c.open) * (1 + 1e-9));
    const auto meets = [&](const Mesh& mesh) {
      return !find_intersections(test::joined(*alone, mesh)).empty();
    };
    if (!meets(c.open)) {
      CHECK(triangles(of_closed) == triangles(*alone));
    }
  });
}

TEST_CASE("law 5: a body with a hole is united as if the hole were filled") {
  test::Random random(23);
  int tested = 0;
  for (int round = 0; round < rounds(); ++round) {
    CAPTURE(round);
    const Mesh a = ball(random), b = ball(random);
    // A ball that encloses the other ball without intersecting it has no effect, by law 2.
    if (find_intersections(test::joined(a, b)).empty()) continue;
    const auto whole = cleaned(test::joined(a, b));
    if (!whole) continue;
    // The hole is an exterior face that does not intersect others.
    const std::vector<Corners> exterior = triangles(*whole);
    const auto hole = std::find_if(a.faces.begin(), a.faces.end(), [&](const Face& f) {
      const Mesh one{a.positions, {f}, {}, {}};
      return std::binary_search(exterior.begin(), exterior.end(), triangles(one).front());
    });
    if (hole == a.faces.end()) continue;
    Mesh punctured = a;
    punctured.faces.erase(punctured.faces.begin() + (hole - a.faces.begin()));
    const auto result = cleaned(test::joined(punctured, b));
    REQUIRE(result);
    const double expected = surface_area(*whole) - surface_area({a.positions, {*hole}, {}, {}});
    CHECK(surface_area(*result) == doctest::Approx(expected).epsilon(1e-9));
    ++tested;
  }
  CHECK(2 * tested > rounds());
}

TEST_CASE("law 5: cleaning balls that a tilted plane cuts gives the cut of the cleaned balls") {
  test::Random random(29);
  int compared = 0;
  for (int round = 0; round < rounds(); ++round) {
    CAPTURE(round);
    Mesh cut;
    CutPlane plane{random.point(-1, 1).normalized(), 1};
    for (int i = 0; i < 2; ++i) {
      const Vec3 center = random.point(-0.5, 0.5);
      const double radius = random.uniform(0.6, 1.2);
      cut = test::joined(cut, test::moved(test::scaled(test::icosphere(2), radius), center));
      // More than half of each ball is left, so that both are bodies with holes.
      plane.offset = std::min(plane.offset, plane.normal.dot(center) - 0.2 * radius);
    }
    Mesh expected = clean(cut).mesh;
    cut_open(expected, plane);
    cut_open(cut, plane);
    if (find_intersections(cut).empty()) continue;  // law 2: a ball inside another one stays
    ++compared;
    CHECK(surface_area(clean(cut).mesh) == doctest::Approx(surface_area(expected)).epsilon(1e-9));
  }
  CHECK(2 * compared > rounds());
}

TEST_CASE(
    "law 5: cleaning boxes with common planes that a plane cuts gives the cut of the cleaned") {
  test::Random random(31);
  const auto whole = [&](double low, double high) { return std::floor(random.uniform(low, high)); };
  int compared = 0;
  for (int round = 0; round < rounds(); ++round) {
    CAPTURE(round);
    Mesh cut;
    std::vector<Eigen::AlignedBox2d> sides;
    for (int i = 0; i < 4; ++i) {
      // Borders of boxes that touch coincide only if the heights are integers.
      const auto height = [&] { return round % 3 == 0 ? whole(1, 4) : random.uniform(1, 3); };
      const Vec3 low(whole(0, 5), whole(0, 5), -height());
      const Vec3 high(low.x() + whole(1, 5), low.y() + whole(1, 5), height());
      cut = test::joined(cut, test::cuboid(low, high));
      sides.emplace_back(low.head<2>(), high.head<2>());
    }
    // Law 2: walls that a body merely surrounds stay.
    const auto surrounds = [](const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b) {
      return (a.min().array() < b.min().array()).all() && (b.max().array() < a.max().array()).all();
    };
    bool is_surrounded = false;
    for (const auto& a : sides)
      for (const auto& b : sides) is_surrounded |= surrounds(a, b);
    if (is_surrounded) continue;
    const double side = round % 2 == 0 ? 1 : -1;
    const CutPlane plane{{0, 0, side}, side / 2};
    Mesh expected = clean(cut).mesh;
    cut_open(expected, plane);
    cut_open(cut, plane);
    CHECK(surface_area(clean(cut).mesh) == doctest::Approx(surface_area(expected)).epsilon(1e-9));
    std::reverse(cut.faces.begin(), cut.faces.end());
    CHECK(surface_area(clean(cut).mesh) == doctest::Approx(surface_area(expected)).epsilon(1e-9));
    ++compared;
  }
  CHECK(2 * compared > rounds());
}
