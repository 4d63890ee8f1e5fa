#include "geometry/source_points.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/search/closest_point.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "mesh/surface_columns.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;

namespace {

/// Returns the cleaned mesh, with the input face of each face.
Mesh cleaned(Mesh mesh) {
  Column& column = mesh.face_columns.get("from", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) column.values[f] = static_cast<double>(f);
  return clean(mesh).mesh;
}

Vec3 middle_of(const Mesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[face];
  return (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
}

bool is_vertex_of(const Mesh& mesh, const Vec3& point) {
  return std::find(mesh.positions.begin(), mesh.positions.end(), point) != mesh.positions.end();
}

/// Returns the distance from the faces at less than 90 degrees to `normal`, by brute force.
double distance_facing(const Mesh& mesh, const Vec3& point, const Vec3& normal) {
  double least = HUGE_VAL;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!(face_normal(mesh, f).dot(normal) > 0)) continue;
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 nearest =
        closest_point_of_triangle(point, mesh.positions[a], mesh.positions[b], mesh.positions[c])
            .point;
    least = std::min(least, (nearest - point).norm());
  }
  return least;
}

RemeshOptions edges_around(double length) {
  RemeshOptions options;
  options.min_edge = 0.7 * length;
  options.max_edge = 1.5 * length;
  return options;
}

}  // namespace

TEST_CASE("source points of a cleaned mesh have its positions, those of input vertices exactly") {
  const Mesh ball = test::icosphere(3);
  const Mesh input = test::joined(ball, test::moved(ball, Vec3(0.9, 0.31, 0.17)));
  const Mesh mesh = cleaned(input);
  REQUIRE(mesh.positions.size() != input.positions.size());
  const std::vector<double>& from = mesh.face_columns.find("from")->values;
  const SourcePoints all = source_points_of_pieces(input, mesh, from);
  const auto& places = all.of_vertices;
  std::size_t made = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const Vec3 place = position_of(input, places[v]);
    CHECK((place - mesh.positions[v]).norm() < 1e-14);
    if (is_vertex_of(input, mesh.positions[v])) {
      CHECK(place == mesh.positions[v]);
    } else {
      ++made;
    }
  }
  CHECK(made > 50);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    CHECK(all.of_faces[f].face == from[f]);
    CHECK((position_of(input, all.of_faces[f]) - middle_of(mesh, f)).norm() < 1e-14);
  }
}

TEST_CASE(
    "source points of a remeshed mesh are the closest with a similar normal, by brute force") {
  const Mesh input = test::torus(2, 0.7, 40, 20);
  Mesh mesh = input;
  remesh(mesh, edges_around(0.3));
  const SourcePoints places = closest_source_points(input, mesh);
  const auto check = [&](const SourcePoint& place, const Vec3& point, const Vec3& normal) {
    const double distance = (position_of(input, place) - point).norm();
    CHECK(std::abs(distance - distance_facing(input, point, normal)) < 1e-12);
  };
  const auto normals = vertex_normals(mesh);
  for (Index v = 0; v < mesh.positions.size(); ++v)
    check(places.of_vertices[v], mesh.positions[v], normals[v]);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    check(places.of_faces[f], middle_of(mesh, f), face_normal(mesh, f));
}

TEST_CASE("no vertex of a thin plate comes from its other side") {
  Mesh input = test::cuboid(Vec3::Zero(), Vec3(4, 4, 1));
  remesh(input, edges_around(0.3));
  for (Vec3& position : input.positions) position.z() *= 0.01;
  Mesh mesh = input;
  RemeshOptions options = edges_around(0.3);
  options.smoothing = Smoothing::laplace;
  options.smooth_first = 0.5;
  remesh(mesh, options);
  const auto places = closest_source_points(input, mesh).of_vertices;
  const auto normals = vertex_normals(mesh);
  std::size_t inner = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (std::abs(normals[v].z()) < 0.99) continue;
    ++inner;
    CHECK(face_normal(input, places[v].face).z() * normals[v].z() > 0);
  }
  CHECK(inner > 200);
}

TEST_CASE("a source point on a sliver is within its longest edge") {
  test::Random random(41);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 a = random.point(-1, 1), b = random.point(-1, 1);
    const Vec3 between = a + random.uniform(0, 1) * (b - a);  // rounded to beside the edge
    const Vec3 query = a + random.uniform(0, 1) * (b - a);
    const Mesh sliver{{a, b, between}, {{0, 1, 2}}, {}, {}};
    CHECK((position_of(sliver, source_point_on(sliver, 0, query)) - query).norm() < 1e-14);
  }
}

TEST_CASE("places are written and read as columns, and checked") {
  const Mesh source = test::tetrahedron();
  Mesh mesh = test::tetrahedron();
  CHECK(!has_source_points(mesh));
  CHECK_THROWS_AS(read_source_points(mesh, 4, "it"), InputError);
  const std::vector<SourcePoint> four{{0, 0, 0}, {1, 0.25, 0.5}, {2, 1, 0}, {3, 0, 1}};
  const SourcePoints places{four, {four.rbegin(), four.rend()}};
  write_source_points(mesh, places);
  REQUIRE(has_source_points(mesh));
  const auto read = read_source_points(mesh, 4, "it");
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(read.of_vertices[i].face == four[i].face);
    CHECK(read.of_vertices[i].weights() == four[i].weights());
    CHECK(read.of_faces[i].face == four[3 - i].face);
    CHECK(read.of_faces[i].weights() == four[3 - i].weights());
  }
  CHECK_THROWS_AS(read_source_points(mesh, 3, "it"), InputError);
  for (Columns Mesh::*const columns : {&Mesh::vertex_columns, &Mesh::face_columns}) {
    for (const double bad : {-1.0, 0.5, std::nan("")}) {
      Mesh broken = mesh;
      (broken.*columns).find("source_face")->values[2] = bad;
      CHECK_THROWS_AS(read_source_points(broken, 4, "it"), InputError);
    }
    Mesh broken = mesh;
    (broken.*columns).find("source_u")->values[2] = 1.5;
    CHECK_THROWS_AS(read_source_points(broken, 4, "it"), InputError);
    (broken.*columns).erase("source_u");
    CHECK(!has_source_points(broken));
  }
}

TEST_CASE("remeshing without places drops those of an earlier step") {
  Mesh mesh = test::icosphere(2);
  write_source_points(mesh, {std::vector<SourcePoint>(mesh.positions.size()),
                             std::vector<SourcePoint>(mesh.faces.size())});
  CHECK(remesh(mesh, edges_around(0.4)).columns.dropped_source_points);
  CHECK(!has_source_columns(mesh.vertex_columns));
  CHECK(!has_source_columns(mesh.face_columns));
}
