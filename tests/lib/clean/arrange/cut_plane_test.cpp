/// Pieces of one plane, against closed forms. Lines in general position divide a face into numbers
/// of points and triangles that Euler's formula gives.
#include "clean/arrange/cut_plane.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "clean/intersect/find_meetings.h"
#include "helpers/shapes.h"
#include "mesh/triangle.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

/// A triangle around the origin in the plane z = 0, and vertical blades through it along tangents
/// of a circle. The blades are in general position, and every two intersect within the triangle.
Mesh blades(int count) {
  Mesh mesh;
  mesh.positions = {{-50, -40, 0}, {60, -30, 0}, {-3, 70, 0}};
  mesh.faces = {{0, 1, 2}};
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * (i + 0.1) / count;
    const Vec3 normal(std::cos(angle), std::sin(angle), 0), along(-normal.y(), normal.x(), 0);
    const Vec3 foot = (0.5 + 0.1 * i) * normal;
    const auto base = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(),
                          {foot - 1e4 * along - Vec3(0, 0, 9), foot + 1e4 * along - Vec3(0, 0, 9),
                           foot + Vec3(0, 0, 1e4)});
    mesh.faces.push_back({base, base + 1, base + 2});
  }
  return mesh;
}

/// Returns the cut of the first face and of the faces that are coplanar with it.
PlaneCut cut_first(const WeldedMesh& welded, const std::vector<Index>& faces) {
  const std::vector<Meeting> meetings = find_meetings(welded, Progress());
  std::vector<const Meeting*> across;
  for (const Meeting& meeting : meetings) {
    const bool here = std::count(faces.begin(), faces.end(), meeting.first) > 0;
    const bool there = std::count(faces.begin(), faces.end(), meeting.second) > 0;
    if (here != there) across.push_back(&meeting);
  }
  return cut_plane(welded, Plane{faces, across});
}

double area_of(const PlaneCut& cut, std::size_t facet) {
  const auto& [a, b, c] = cut.facets[facet];
  return normal_of(cut.points[a].center, cut.points[b].center, cut.points[c].center).z() / 2;
}

}  // namespace

TEST_CASE("n blades cut a face into as many parts as n lines in general position") {
  for (const int n : {0, 1, 2, 3, 7, 12}) {
    CAPTURE(n);
    const WeldedMesh welded = weld(blades(n));
    const PlaneCut cut = cut_first(welded, {0});
    const int inside = n * (n - 1) / 2, on_border = 3 + 2 * n;
    CHECK(cut.points.size() == static_cast<std::size_t>(inside + on_border));
    CHECK(cut.facets.size() == static_cast<std::size_t>(2 * inside + on_border - 2));
    double area = 0;
    for (std::size_t i = 0; i < cut.facets.size(); ++i) {
      CHECK(area_of(cut, i) > 0);
      area += area_of(cut, i);
      REQUIRE(cut.source_offsets[i + 1] - cut.source_offsets[i] == 1);
      CHECK(cut.sources[cut.source_offsets[i]].face == 0);
      CHECK(!cut.sources[cut.source_offsets[i]].reversed);
    }
    const Triangle whole = welded.triangle(0);
    CHECK(area == doctest::Approx(normal_of(whole[0], whole[1], whole[2]).z() / 2));
  }
}

TEST_CASE("no facet crosses a line") {
  const int n = 9;
  const Mesh mesh = blades(n);
  const PlaneCut cut = cut_first(weld(mesh), {0});
  for (const Face& facet : cut.facets) {
    for (Index f = 1; f < mesh.faces.size(); ++f) {
      const Triangle blade = triangle_of(mesh, f);
      const Vec3 normal = normal_of(blade[0], blade[1], blade[2]).normalized();
      double low = 0, high = 0;
      for (const Index v : facet) {
        const double height = normal.dot(cut.points[v].center - blade[0]);
        low = std::min(low, height);
        high = std::max(high, height);
      }
      CHECK(std::min(-low, high) < 1e-9);
    }
  }
}

TEST_CASE("coplanar faces share pieces where they overlap, with the orientation of each") {
  // The square of the first two faces, and a reversed square of the same size that covers a quarter
  // of it.
  const Mesh square = test::grid(1);
  const Mesh other = test::reversed(test::moved(square, {0.5, 0.5, 0}));
  const WeldedMesh welded = weld(test::joined(square, other));
  const PlaneCut cut = cut_first(welded, {0, 1, 2, 3});
  double once = 0, twice = 0;
  for (std::size_t i = 0; i < cut.facets.size(); ++i) {
    const Index first = cut.source_offsets[i], last = cut.source_offsets[i + 1];
    REQUIRE(last - first >= 1);
    REQUIRE(last - first <= 2);
    (last - first == 1 ? once : twice) += std::abs(area_of(cut, i));
    for (Index s = first; s < last; ++s)
      CHECK(cut.sources[s].reversed == (cut.sources[s].face >= 2));
  }
  CHECK(twice == doctest::Approx(0.25).epsilon(1e-14));
  CHECK(once == doctest::Approx(1.5).epsilon(1e-14));
}
