/// Columns, provenance and locality of cleaning, checked by closed forms and exact rationals.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "mesh/triangle.h"
#include "transformesh/clean.h"

using namespace transformesh;

namespace {

using Rational = boost::multiprecision::cpp_rational;
using ExactVec = std::array<Rational, 3>;

ExactVec exact(const Vec3& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }

ExactVec minus(const ExactVec& a, const ExactVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

ExactVec cross(const ExactVec& a, const ExactVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const ExactVec& a, const ExactVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const ExactVec& a) { return std::sqrt(dot(a, a).convert_to<double>()); }

/// Returns how far the point lies outside of the triangle. This is the largest of its distance from
/// the plane and, within the plane, its distances beyond the edges.
double distance_outside(const Vec3& point, const Triangle& triangle) {
  const ExactVec p = exact(point), a = exact(triangle[0]), b = exact(triangle[1]),
                 c = exact(triangle[2]);
  const ExactVec normal = cross(minus(b, a), minus(c, a));
  double worst = std::abs(dot(normal, minus(p, a)).convert_to<double>()) / length(normal);
  const std::array<std::array<ExactVec, 2>, 3> sides = {{{a, b}, {b, c}, {c, a}}};
  for (const auto& [from, to] : sides) {
    const ExactVec inwards = cross(normal, minus(to, from));
    const Rational beyond = -dot(inwards, minus(p, from));
    if (beyond > 0) worst = std::max(worst, beyond.convert_to<double>() / length(inwards));
  }
  return worst;
}

double linear(const Vec3& p) { return 3 - 2 * p[0] + p[1] + 5 * p[2]; }

double largest_coordinate(const Mesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

/// Adds columns: a linear function of the position, the number of each vertex, and the number of
/// each face.
Mesh with_columns(Mesh mesh) {
  const std::size_t vertices = mesh.positions.size();
  Column& height = mesh.vertex_columns.get("height", Scalar::float64, vertices);
  for (std::size_t v = 0; v < vertices; ++v) height.values[v] = linear(mesh.positions[v]);
  Column& vertex = mesh.vertex_columns.get("vertex", Scalar::int32, vertices);
  for (std::size_t v = 0; v < vertices; ++v) vertex.values[v] = static_cast<double>(v);
  Column& face = mesh.face_columns.get("face", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) face.values[f] = static_cast<double>(f);
  return mesh;
}

const std::vector<double>& values(const Columns& columns, const char* name) {
  return columns.find(name)->values;
}

Triangle triangle(const Mesh& mesh, Index face) {
  const Face& f = mesh.faces[face];
  return {mesh.positions[f[0]], mesh.positions[f[1]], mesh.positions[f[2]]};
}

/// Uncut input faces come first and unchanged, in their order; so do input vertices.
void check_order(const Mesh& input, const Mesh& output, std::size_t new_vertices) {
  const auto& vertex = values(output.vertex_columns, "vertex");
  const std::size_t old_vertices = output.positions.size() - new_vertices;
  double before = -1;
  bool in_order = true, in_place = true;
  for (std::size_t v = 0; v < old_vertices; ++v) {
    in_order = in_order && vertex[v] > before;
    before = vertex[v];
    in_place = in_place && output.positions[v] == input.positions[static_cast<Index>(vertex[v])];
  }
  CHECK(in_order);
  CHECK(in_place);
  const auto& source = values(output.face_columns, "face");
  std::size_t whole = 0;
  for (before = -1; whole < output.faces.size(); ++whole) {
    const auto face = static_cast<Index>(source[whole]);
    if (source[whole] <= before ||
        triangle(input, face) != triangle(output, static_cast<Index>(whole)))
      break;
    before = source[whole];
  }
  // All later faces are pieces, smaller than their sources.
  bool only_pieces = true;
  for (std::size_t f = whole; f < output.faces.size(); ++f) {
    only_pieces = only_pieces && triangle(input, static_cast<Index>(source[f])) !=
                                     triangle(output, static_cast<Index>(f));
  }
  CHECK(only_pieces);
  CHECK(whole > 0);
}

/// Checks everything that cleaning promises about columns.
void check_columns(const Mesh& plain, const CleanOptions& options = {}) {
  const Mesh input = with_columns(plain);
  const CleanResult result = clean(input, options);
  const Mesh& output = result.mesh;
  REQUIRE(result.changed);
  const double scale = largest_coordinate(input);
  const double digits = options.coordinate == Scalar::float32 ? 24 : 53;
  // The largest movement of a vertex when vertices merge.
  const double rounding = scale * std::ldexp(1, 5 - static_cast<int>(digits));

  double worst_height = 0;
  for (std::size_t v = 0; v < output.positions.size(); ++v) {
    const double error = values(output.vertex_columns, "height")[v] - linear(output.positions[v]);
    worst_height = std::max(worst_height, std::abs(error));
  }
  CHECK(worst_height <= 2 * rounding);

  // A number that is not interpolated comes from a corner of a face on which the vertex lies.
  double worst_place = 0;
  std::vector<char> is_corner(output.positions.size(), 0);
  for (Index f = 0; f < output.faces.size(); ++f) {
    const auto source = static_cast<Index>(values(output.face_columns, "face")[f]);
    for (const Index v : output.faces[f]) {
      const double outside = distance_outside(output.positions[v], triangle(input, source));
      worst_place = std::max(worst_place, outside);
      for (const Index corner : input.faces[source]) {
        if (values(output.vertex_columns, "vertex")[v] == corner) is_corner[v] = 1;
      }
    }
  }
  CHECK(worst_place <= rounding / 2);
  CHECK(std::count(is_corner.begin(), is_corner.end(), 0) == 0);
  check_order(input, output, result.new_vertices + result.copied_vertices);
}

Mesh two_balls() {
  return test::joined(test::icosphere(3), test::moved(test::icosphere(3), {0.71, 0.33, 0.2}));
}

Mesh as_float(Mesh mesh) {
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
  return mesh;
}

}  // namespace

TEST_CASE("columns: two balls, here and far away") {
  check_columns(two_balls());
  for (const double far : {1e3, 1e6, 1e9}) {
    CAPTURE(far);
    check_columns(test::moved(two_balls(), {far, far / 3, -far}));
  }
}

TEST_CASE("columns: boxes with coplanar and coincident faces") {
  check_columns(
      test::joined(test::cuboid({0, 0, 0}, {3, 2, 2}), test::cuboid({1, 0, 0}, {4, 1, 2})));
}

TEST_CASE("columns: many faces through each other") {
  check_columns(make_shape(test::shape("tangle", 4000)));
}

TEST_CASE("columns: needles") {
  test::Random random(11);
  for (int round = 0; round < 20; ++round) {
    CAPTURE(round);
    const double thin = round % 2 == 0 ? 1e-5 : 1e-9;
    Mesh needle = test::cuboid({-1, -thin, -thin}, {1, thin, 1.3 * thin});
    const Eigen::AngleAxisd rotation(random.uniform(0, 3), random.point(-1, 1).normalized());
    for (Vec3& p : needle.positions) p = rotation * p;
    check_columns(test::joined(test::scaled(test::icosphere(1), 0.5), needle));
  }
}

TEST_CASE("columns: floats") {
  CleanOptions options;
  options.coordinate = Scalar::float32;
  check_columns(as_float(two_balls()), options);
  check_columns(as_float(make_shape(test::shape("tangle", 4000))), options);
}

TEST_CASE("columns: untouched faces keep every bit") {
  Mesh mesh = two_balls();
  Column& odd = mesh.vertex_columns.get("odd", Scalar::float32, mesh.positions.size());
  for (std::size_t v = 0; v < odd.values.size(); ++v) odd.values[v] = v % 2 == 0 ? -0.0 : NAN;
  mesh.positions[10][1] = -0.0;
  const Mesh input = with_columns(mesh);
  const CleanResult result = clean(input);
  REQUIRE(result.changed);
  const Mesh& output = result.mesh;
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  std::size_t differences = 0, compared = 0;
  for (std::size_t v = 0; v + result.new_vertices < output.positions.size(); ++v) {
    const auto from = static_cast<std::size_t>(values(output.vertex_columns, "vertex")[v]);
    ++compared;
    for (int i = 0; i < 3; ++i) {
      differences += bits(output.positions[v][i]) != bits(input.positions[from][i]) ? 1 : 0;
    }
    differences += bits(values(output.vertex_columns, "odd")[v]) !=
                           bits(values(input.vertex_columns, "odd")[from])
                       ? 1
                       : 0;
  }
  CHECK(compared > 500);
  CHECK(differences == 0);
}

TEST_CASE("--refuse names the defect of a soup without intersections") {
  const Mesh ball = test::icosphere(2);
  Mesh soup;
  for (const Face& face : ball.faces) {
    for (const Index v : face) soup.positions.push_back(ball.positions[v]);
    const auto last = static_cast<Index>(soup.positions.size());
    soup.faces.push_back({last - 3, last - 2, last - 1});
  }
  CleanOptions options;
  options.refuse = true;
  CHECK_THROWS_WITH(clean(soup, options),
                    "the mesh needs cleaning (0 intersecting face pairs, 0 faces to remove, 0 "
                    "vertices to duplicate, but vertices to merge)");
  CHECK(clean(ball, options).mesh.positions == ball.positions);
}
