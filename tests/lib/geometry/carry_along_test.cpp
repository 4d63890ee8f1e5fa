#include <doctest/doctest.h>

#include "geometry/source_points.h"
#include "helpers/shapes.h"
#include "transformesh/carry.h"
#include "transformesh/errors.h"
#include "transformesh/remesh.h"

using namespace transformesh;

namespace {

/// A sphere with the column x = position.x.
Mesh first_mesh() {
  Mesh mesh = test::icosphere(3);
  Column& column = mesh.vertex_columns.get("x", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) column.values[v] = mesh.positions[v].x();
  return mesh;
}

Mesh remeshed(Mesh mesh, double min_edge, bool with_points) {
  mesh.vertex_columns.erase("x");
  RemeshOptions options;
  options.min_edge = min_edge;
  options.max_edge = 2 * min_edge;
  change_with_source_points(with_points, mesh,
                            [&](Mesh& changed) { return remesh(changed, options); });
  return mesh;
}

void check_values(const Mesh& mesh) {
  const Column* carried = mesh.vertex_columns.find("x");
  REQUIRE(carried != nullptr);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK(std::abs(carried->values[v] - mesh.positions[v].x()) < .03);
}

}  // namespace

TEST_CASE("a linear column follows a chain of two remeshings") {
  const Mesh first = first_mesh();
  const Mesh middle = remeshed(first, .1, true);
  Mesh last = remeshed(middle, .15, true);
  const std::array before{&first, &middle};
  CHECK(carry_along(before, last).vertex_columns == 1);
  check_values(last);
  // The source points of the last mesh now refer to the first one.
  const SourcePoints places = read_source_points(last, first.faces.size(), "the first mesh");
  for (Index v = 0; v < last.positions.size(); ++v)
    CHECK((position_of(first, places.of_vertices[v]) - last.positions[v]).norm() < .03);
}

TEST_CASE("a mesh without source points is named, unless the closest places are wanted") {
  const Mesh first = first_mesh();
  Mesh last = remeshed(first, .1, false);
  const std::array before{&first};
  CarryOptions options;
  options.names = {"a.ply", "b.ply"};
  try {
    carry_along(before, last, options);
    FAIL("places were made up");
  } catch (const InputError& error) {
    CHECK(error.kind() == ErrorKind::no_source_points);
    CHECK(error.problem().sentence.starts_with("b.ply "));
  }
  options.closest = true;
  carry_along(before, last, options);
  check_values(last);
}

TEST_CASE("closest points are refused for meshes whose areas overflow or vanish") {
  const Mesh first = first_mesh();
  const Mesh last = remeshed(first, .1, false);
  CarryOptions options;
  options.closest = true;
  const auto carried = [&](double factor) {
    const Mesh scaled_first = test::scaled(first, factor);
    Mesh scaled_last = test::scaled(last, factor);
    carry_along(std::array{&scaled_first}, scaled_last, options);
    return scaled_last;
  };
  for (const double factor : {1e-200, 1e-100, 1e-76, 1e75, 1e78, 1e100})
    CHECK_THROWS_AS(carried(factor), InputError);
  const std::vector<double> usual = carried(1).vertex_columns.find("x")->values;
  for (const double factor : {1e-75, 1e74}) {
    const Mesh mesh = carried(factor);
    const std::vector<double>& values = mesh.vertex_columns.find("x")->values;
    for (std::size_t v = 0; v < usual.size(); ++v)
      CHECK(values[v] == doctest::Approx(usual[v]).epsilon(1e-6));
  }
}

TEST_CASE("names of columns are looked up, and a chain has a first mesh") {
  const Mesh first = first_mesh();
  Mesh last = remeshed(first, .1, true);
  CarryOptions options;
  options.columns = {"no_such_column"};
  const std::array before{&first};
  CHECK_THROWS_AS(carry_along(before, last, options), InputError);
  CHECK_THROWS_AS(carry_along({}, last), UsageError);
}
