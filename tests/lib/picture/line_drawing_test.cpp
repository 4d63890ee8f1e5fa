#include "picture/line_drawing.h"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include "helpers/shapes.h"
#include "picture/panels.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

const Mesh block = cuboid({-1, -1, -1}, {1, 1, 1});

PictureOptions corner_view(int width, int height) {
  PictureOptions options;
  options.width = width;
  options.height = height;
  options.orbit = {30, 20, Axis::y, 1};
  return options;
}

std::string draw(std::vector<const Mesh*> meshes, const PictureOptions& options) {
  return draw_lines(meshes, options);
}

using Polyline = std::vector<Eigen::Vector2d>;

/// Returns the polylines of the paths of a class.
std::vector<Polyline> lines_of(const std::string& svg, const std::string& kind) {
  std::vector<Polyline> lines;
  for (std::size_t at = 0; (at = svg.find("class=\"" + kind + "\"", at)) != std::string::npos;) {
    const std::size_t first = svg.find(" d=\"", at) + 4;
    at = svg.find('"', first);
    std::string data = svg.substr(first, at - first);
    for (char& c : data)
      if (c == 'L') c = ' ';
    std::istringstream paths(data);
    std::string path;
    std::getline(paths, path, 'M');
    while (std::getline(paths, path, 'M')) {
      Polyline& line = lines.emplace_back();
      std::istringstream numbers(path);
      for (double x = 0, y = 0; numbers >> x >> y;) line.emplace_back(x, y);
    }
  }
  return lines;
}

double length_of(const std::vector<Polyline>& lines) {
  double length = 0;
  for (const Polyline& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

/// Returns the length of the image of an edge.
double image_length(const Camera& camera, const Vec3& a, const Vec3& b) {
  const Vec3 p = camera.project(a);
  const Vec3 q = camera.project(b);
  return (p.head<2>() / p.z() - q.head<2>() / q.z()).norm();
}

}  // namespace

TEST_CASE(
    "of a cube's corner view six edges are its outline, three are creases, three are hidden") {
  const PictureOptions options = corner_view(300, 200);
  const std::string svg = draw({&block}, options);
  CHECK(svg.find("width=\"300\" height=\"200\" viewBox=\"0 0 300 200\"") != std::string::npos);
  const std::vector<Polyline> outlines = lines_of(svg, "outlines");
  REQUIRE(outlines.size() == 1);
  CHECK(outlines[0].size() == 7);
  CHECK(outlines[0].front() == outlines[0].back());
  CHECK(lines_of(svg, "edges").empty());

  // The eye is in front, to the right and above, so the faces towards +x, +y and +z are visible.
  const std::vector<const Mesh*> meshes{&block};
  const Camera camera = lay_out(meshes, options, 0)[0].camera;
  const Vec3 near(1, 1, 1);
  double creases = 0;
  for (const Vec3& other : {Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)})
    creases += image_length(camera, near, other);
  CHECK(length_of(lines_of(svg, "creases")) == doctest::Approx(creases).epsilon(0.001));
  const Vec3 q = camera.project({-1, 1, 1});
  const Eigen::Vector2d corner = q.head<2>() / q.z() + Eigen::Vector2d(0.5, 0.5);
  const bool is_there = std::any_of(outlines[0].begin(), outlines[0].end(), [&](const auto& place) {
    return (place - corner).norm() < 0.01;
  });
  CHECK(is_there);
}

TEST_CASE("with edges, the diagonals of the three front faces of a cube are drawn too") {
  PictureOptions options = corner_view(300, 200);
  options.shade.draw_edges = true;
  const std::string svg = draw({&block}, options);
  std::size_t diagonals = 0;
  for (const Polyline& line : lines_of(svg, "edges")) diagonals += line.size() - 1;
  CHECK(diagonals == 3);
  CHECK(length_of(lines_of(svg, "outlines")) ==
        length_of(lines_of(draw({&block}, corner_view(300, 200)), "outlines")));
}

TEST_CASE("the outline of a sphere is the circle of the cone that touches it") {
  const Mesh ball = icosphere(5);
  PictureOptions options = corner_view(200, 200);
  const std::string svg = draw({&ball}, options);
  const std::vector<Polyline> outlines = lines_of(svg, "outlines");
  // The ball fills 0.92 of the picture.
  for (const Polyline& line : outlines)
    for (const Eigen::Vector2d& place : line)
      CHECK((place - Eigen::Vector2d(100, 100)).norm() == doctest::Approx(92).epsilon(0.005));
  CHECK(length_of(outlines) == doctest::Approx(2 * 3.14159265358979 * 92).epsilon(0.01));
  CHECK(lines_of(svg, "creases").empty());
}

TEST_CASE("borders are outlines; segments are drawn; hidden parts are not") {
  Mesh sheet = moved(scaled(grid(3), 2), {-1, -1, 0});
  PictureOptions options = corner_view(100, 100);
  options.orbit = {0, 0, Axis::y, 1};
  options.shade.segments = {{Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0)}, {Vec3(-1, 0, -1), Vec3(1, 0, -1)}};
  const std::string svg = draw({&sheet}, options);
  CHECK(length_of(lines_of(svg, "outlines")) == doctest::Approx(4 * 92).epsilon(0.001));
  CHECK(length_of(lines_of(svg, "segments")) == doctest::Approx(23 * 2).epsilon(0.001));
}

TEST_CASE("panels and views have groups of their own, within their borders") {
  PictureOptions options = corner_view(300, 100);
  options.views = 3;
  options.orbit.zoom = 3;
  const std::string svg = draw({&block}, options);
  std::size_t groups = 0;
  for (std::size_t at = 0; (at = svg.find("<g>", at)) != std::string::npos; ++at) ++groups;
  CHECK(groups == 3);
  for (const char* kind : {"creases", "outlines"})
    for (const Polyline& line : lines_of(svg, kind))
      for (const Eigen::Vector2d& place : line)
        CHECK(std::floor(place.x() / 100 - 1e-9) <= std::floor(line[0].x() / 100 + 1e-9));
}

TEST_CASE("the same bytes for any number of threads; errors are those of pictures") {
  PictureOptions options = corner_view(200, 200);
  options.shade.draw_edges = true;
  const Mesh ring = torus(1, 0.4, 60, 30);
  const std::string all = draw({&ring, &block}, options);
  const ThreadLimit one(1);
  CHECK(draw({&ring, &block}, options) == all);
  const Mesh empty;
  CHECK_THROWS_AS(draw({&empty}, options), InputError);
}
