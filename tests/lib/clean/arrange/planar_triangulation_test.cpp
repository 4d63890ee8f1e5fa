/// Random segments on a lattice, where points often coincide, are collinear or lie on segments.
/// The oracle counts intersections and incidences in rational arithmetic.
#include "clean/arrange/planar_triangulation.h"

#include <doctest/doctest.h>

#include <set>

#include "helpers/random.h"
#include "helpers/rational.h"

using namespace transformesh;

namespace {

constexpr Index scaffold_points = PlanarTriangulation::scaffold_points;

/// Segments between points of a lattice in a tilted plane.
struct Drawing {
  std::vector<Vec3> points;
  std::vector<std::array<Index, 2>> segments;
};

Drawing random_drawing(std::uint64_t seed, std::size_t segments) {
  test::Random random(seed);
  Drawing drawing;
  while (drawing.segments.size() < segments) {
    std::array<Vec3, 2> ends;
    for (Vec3& end : ends) {
      const double x = static_cast<double>(random.below(6));
      const double y = static_cast<double>(random.below(6));
      end = Vec3(x, y, 2 * x - 3 * y + 1);
    }
    if (ends[0] == ends[1]) continue;
    const auto first = static_cast<Index>(drawing.points.size());
    drawing.points.insert(drawing.points.end(), ends.begin(), ends.end());
    drawing.segments.push_back({first, first + 1});
  }
  return drawing;
}

/// Returns all ends and intersections of segments as rationals.
std::set<test::RationalPoint> expected_points(const Drawing& drawing) {
  std::set<test::RationalPoint> points;
  for (const Vec3& p : drawing.points) points.insert(test::exact(p));
  const auto end = [&](std::size_t s, std::size_t i) {
    return test::exact(drawing.points[drawing.segments[s][i]]);
  };
  for (std::size_t s = 0; s < drawing.segments.size(); ++s) {
    for (std::size_t t = s + 1; t < drawing.segments.size(); ++t) {
      const auto point = test::crossing(end(s, 0), end(s, 1), end(t, 0), end(t, 1));
      if (point) points.insert(*point);
    }
  }
  return points;
}

class Triangulated {
 public:
  explicit Triangulated(const Drawing& drawing)
      : drawing_(drawing),
        geometry_(drawing_.points, {}),
        triangulation_(geometry_, {Vec3(0, 0, 1), Vec3(1, 0, 3), Vec3(0, 1, -2)}, Vec3(0, 0, -14),
                       Vec3(5, 5, 11), [this](Index a, Index b) {
                         const auto [u, v] = drawing_.segments[a];
                         const auto [x, y] = drawing_.segments[b];
                         return geometry_.point(PointDefinition::line_line(u, v, x, y));
                       }) {
    for (Index s = 0; s < drawing.segments.size(); ++s) {
      for (const Index end : drawing.segments[s])
        ids.push_back(triangulation_.insert(geometry_.given(end), {s}));
    }
    for (Index s = 0; s < drawing.segments.size(); ++s)
      triangulation_.constrain(ids[2 * s], ids[2 * s + 1], s);
  }

  const PlanarTriangulation& operator*() const { return triangulation_; }
  void improve() { triangulation_.improve(); }
  Vec3 position(Index i) const { return geometry_.position(triangulation_.point(i)); }
  std::vector<Index> ids;  ///< numbers of the points at the ends of all segments

 private:
  const Drawing drawing_;
  ExactGeometry geometry_;
  PlanarTriangulation triangulation_;
};

double twice_area(const Triangulated& triangulated, const Face& v) {
  const Vec3 a = triangulated.position(v[0]);
  const Vec3 b = triangulated.position(v[1]) - a, c = triangulated.position(v[2]) - a;
  return b.x() * c.y() - b.y() * c.x();
}

/// Returns the lines on an edge with their directions, latest first.
std::vector<std::pair<Index, int>> lines_on(const PlanarTriangulation& triangulation, Index facet,
                                            Index i, int sign) {
  std::vector<std::pair<Index, int>> lines;
  triangulation.for_each_line(facet, i, [&](const PlanarTriangulation::OnEdge& on) {
    lines.emplace_back(on.line, on.is_along ? sign : -sign);
  });
  return lines;
}

/// Checks that facets cover the scaffold once and refer to their neighbors.
void check_facets(const Triangulated& triangulated) {
  const auto& facets = (*triangulated).facets();
  CHECK(facets.size() == 2 * ((*triangulated).point_count() - scaffold_points) + 1);
  double sum = 0;
  for (Index f = 0; f < facets.size(); ++f) {
    const double area = twice_area(triangulated, facets[f].v);
    REQUIRE(area > 0);
    sum += area;
    for (Index i = 0; i < 3; ++i) {
      const Index g = facets[f].next[i];
      if (g == no_index) continue;
      const auto back = std::find(facets[g].next.begin(), facets[g].next.end(), f);
      REQUIRE(back != facets[g].next.end());
      const auto k = static_cast<std::size_t>(back - facets[g].next.begin());
      REQUIRE(facets[g].v[k] == facets[f].v[(i + 1) % 3]);
      REQUIRE(facets[g].v[(k + 1) % 3] == facets[f].v[i]);
      REQUIRE(lines_on(*triangulated, f, i, 1) ==
              lines_on(*triangulated, g, static_cast<Index>(k), -1));
    }
  }
  CHECK(sum == doctest::Approx(twice_area(triangulated, {0, 1, 2})));
}

/// Checks that every segment is a chain of constrained edges through all points on it.
void check_chains(const Triangulated& triangulated, const Drawing& drawing,
                  const std::set<test::RationalPoint>& points) {
  for (std::size_t s = 0; s < drawing.segments.size(); ++s) {
    const test::RationalPoint a = test::exact(drawing.points[drawing.segments[s][0]]);
    const test::RationalPoint b = test::exact(drawing.points[drawing.segments[s][1]]);
    const auto on_segment =
        std::count_if(points.begin(), points.end(),
                      [&](const test::RationalPoint& p) { return test::contains(a, b, p); });
    const auto chain = (*triangulated)
                           .chain(triangulated.ids[2 * s], triangulated.ids[2 * s + 1],
                                  {static_cast<Index>(s), true});
    REQUIRE(static_cast<std::ptrdiff_t>(chain.size()) == on_segment - 1);
    for (const Index edge : chain) {
      const auto lines = lines_on(*triangulated, edge / 3, edge % 3, 1);
      REQUIRE(std::count(lines.begin(), lines.end(), std::pair(static_cast<Index>(s), 1)) == 1);
    }
  }
}

}  // namespace

TEST_CASE("segments on a lattice become edges, and their crossings become points") {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    const Drawing drawing = random_drawing(seed, 2 + seed % 14);
    const std::set<test::RationalPoint> points = expected_points(drawing);
    Triangulated triangulated(drawing);
    CHECK((*triangulated).point_count() == points.size() + scaffold_points);
    check_facets(triangulated);
    check_chains(triangulated, drawing, points);
    triangulated.improve();
    check_facets(triangulated);
    check_chains(triangulated, drawing, points);
  }
}

TEST_CASE("equal points are merged, and keep all lines through them") {
  const Drawing drawing = random_drawing(5, 8);
  const Triangulated triangulated(drawing);
  std::map<std::array<double, 3>, Index> id_at;
  for (std::size_t i = 0; i < drawing.points.size(); ++i) {
    const Vec3& p = drawing.points[i];
    const Index id = id_at.try_emplace({p.x(), p.y(), p.z()}, triangulated.ids[i]).first->second;
    CHECK(id == triangulated.ids[i]);
    CHECK(triangulated.position(id) == p);
  }
}

TEST_CASE("without constraints improving makes it Delaunay") {
  test::Random random(9);
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i) points.emplace_back(random.uniform(0, 1), random.uniform(0, 1), 0);
  const ExactGeometry geometry(points, {});
  PlanarTriangulation triangulation(geometry, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                    Vec3(0, 0, 0), Vec3(1, 1, 0), nullptr);
  for (Index i = 0; i < points.size(); ++i) triangulation.insert(geometry.given(i), {});
  triangulation.improve();
  const auto at = [&](Index i) { return triangulation.point(i).center; };
  int tested = 0;
  for (const PlanarTriangulation::Facet& facet : triangulation.facets()) {
    // The perpendicular bisectors of b and c meet in the center of the circumcircle.
    const Vec3 a = at(facet.v[0]), b = at(facet.v[1]) - a, c = at(facet.v[2]) - a;
    const double area = b.x() * c.y() - b.y() * c.x();
    const Vec3 center = a + Vec3(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                                 b.x() * c.squaredNorm() - c.x() * b.squaredNorm(), 0) /
                                (2 * area);
    const double radius = (center - a).norm();
    for (Index i = scaffold_points; i < triangulation.point_count(); ++i) {
      CHECK((at(i) - center).norm() >= radius * (1 - 1e-7));
      ++tested;
    }
  }
  CHECK(tested == 121 * 60);
}
