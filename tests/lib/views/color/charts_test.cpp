#include "views/color/charts.h"

#include <doctest/doctest.h>

#include <set>

#include "helpers/shapes.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

double area_of(const Chart& chart) {
  double area = 0;
  for (const auto& [a, b, c] : chart.corners) {
    const Eigen::Vector2d ab = b - a, ac = c - a;
    area += (ab.x() * ac.y() - ab.y() * ac.x()) / 2;
  }
  return area;
}

void check_charts(const Mesh& mesh, const std::vector<Chart>& charts) {
  std::multiset<Index> faces;
  for (const Chart& chart : charts) {
    faces.insert(chart.faces.begin(), chart.faces.end());
    REQUIRE(chart.corners.size() == chart.faces.size());
    CHECK(chart.size.x() >= chart.size.y());
    for (const auto& corners : chart.corners)
      for (const Eigen::Vector2d& corner : corners) {
        CHECK(corner.minCoeff() >= -1e-12);
        CHECK((chart.size - corner).minCoeff() >= -1e-12);
      }
  }
  CHECK(faces.size() == mesh.faces.size());
  CHECK(std::set<Index>(faces.begin(), faces.end()).size() == mesh.faces.size());
}

}  // namespace

TEST_CASE("a flat sheet is one chart with its own area") {
  const Mesh mesh = test::scaled(test::grid(6), 3);
  const std::vector<Chart> charts = make_charts(mesh, .01);
  check_charts(mesh, charts);
  REQUIRE(charts.size() == 1);
  CHECK(std::abs(area_of(charts[0])) == doctest::Approx(9));
  CHECK(charts[0].size.prod() == doctest::Approx(9));
}

TEST_CASE("charts of a box leave no face out and lose at most half of each length") {
  const Mesh mesh = test::cuboid(Vec3::Zero(), {1, 2, 3});
  const std::vector<Chart> charts = make_charts(mesh, .01);
  check_charts(mesh, charts);
  double area = 0;
  for (const Chart& chart : charts) area += std::abs(area_of(chart));
  CHECK(area <= surface_area(mesh) * (1 + 1e-12));
  CHECK(area >= surface_area(mesh) / 2);
}

TEST_CASE("charts of a sphere and of a soup hold every face once") {
  const Mesh sphere = test::icosphere(3);
  const std::vector<Chart> charts = make_charts(sphere, .01);
  check_charts(sphere, charts);
  CHECK(charts.size() > 1);
  CHECK(charts.size() < 50);
  const Mesh soup = test::soup_of(test::icosphere(1));
  CHECK(make_charts(soup, .01).size() == soup.faces.size());
}
