#include "transformesh/carry.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/search/closest_point.h"
#include "geometry/source_points.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using doctest::Approx;

namespace {

const Vec3 slope(1, -2, 0.5);

/// Adds a column that is a linear function of position.
Mesh with_height(Mesh mesh) {
  Column& column = mesh.vertex_columns.get("height", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    column.values[v] = slope.dot(mesh.positions[v]);
  return mesh;
}

Mesh cleaned(Mesh mesh) {
  const Mesh input = mesh;
  Column& column = mesh.face_columns.get("from", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) column.values[f] = static_cast<double>(f);
  mesh = clean(mesh).mesh;
  write_source_points(mesh,
                      source_points_of_pieces(input, mesh, mesh.face_columns.find("from")->values));
  return mesh;
}

Mesh remeshed(Mesh mesh, double length) {
  const Mesh input = mesh;
  RemeshOptions options;
  options.min_edge = 0.7 * length;
  options.max_edge = 1.5 * length;
  options.iterations = 2;
  remesh(mesh, options);
  write_source_points(mesh, closest_source_points(input, mesh));
  return mesh;
}

SourcePoints places_of(const Mesh& mesh, const Mesh& source) {
  return read_source_points(mesh, source.faces.size(), "the source");
}

/// Returns the angles of a point around the axis of a torus and around its ring, in turns from 0 to
/// 1.
std::pair<double, double> turns_of(const Vec3& point, double major) {
  const auto turns = [](double y, double x) {
    const double angle = std::atan2(y, x) / (2 * std::numbers::pi);
    return angle < 0 ? angle + 1 : angle;
  };
  return {turns(point.y(), point.x()), turns(point.z(), std::hypot(point.x(), point.y()) - major)};
}

/// Adds texture coordinates by angles, with a seam along each turn, which cut the torus into one
/// sheet.
Mesh with_texture(Mesh mesh, double major) {
  Column column{"texcoord", Scalar::float64, {}, Scalar::uint8, {0}};
  for (const Face& face : mesh.faces) {
    std::array<std::array<double, 2>, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [s, t] = turns_of(mesh.positions[face[i]], major);
      at[i] = {s, t};
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double most = std::max({at[0][axis], at[1][axis], at[2][axis]});
      for (auto& corner : at)
        if (most - corner[axis] > 0.5) corner[axis] += 1;
    }
    for (const auto& corner : at)
      column.values.insert(column.values.end(), corner.begin(), corner.end());
    column.list_offsets.push_back(column.values.size());
  }
  mesh.face_columns.columns.push_back(column);
  return mesh;
}

}  // namespace

TEST_CASE(
    "a linear function carried through clean, a motion and remesh is that of a place nearby") {
  const Mesh ball = test::icosphere(3);
  const Mesh first = with_height(test::joined(ball, test::moved(ball, Vec3(0.9, 0.31, 0.17))));
  const Mesh clean_one = cleaned(first);
  Mesh moved = clean_one;
  for (Vec3& p : moved.positions) p = 3 * p;
  const Mesh second = remeshed(moved, 0.5);
  Mesh last = remeshed(second, 0.35);
  auto places = places_of(clean_one, first);
  places = compose_source_points(first, places, moved, places_of(second, moved));
  places = compose_source_points(first, places, second, places_of(last, second));

  last.vertex_columns.erase("height");
  const CarryResult result = carry_columns(first, places, last);
  CHECK(result.vertex_columns == 1);
  CHECK(result.face_columns == 0);
  const std::vector<double>& height = last.vertex_columns.find("height")->values;
  double squares = 0;
  for (std::size_t v = 0; v < last.positions.size(); ++v) {
    // The value is exactly that of the source point. That point is where the vertex was before the
    // motion, except at edges across the crease where the balls meet.
    const Vec3 place = position_of(first, places.of_vertices[v]);
    CHECK(std::abs(height[v] - slope.dot(place)) < 1e-12);
    CHECK((3 * place - last.positions[v]).norm() < 0.3 * 0.35);
    squares += (3 * place - last.positions[v]).squaredNorm();
  }
  CHECK(std::sqrt(squares / static_cast<double>(last.positions.size())) < 0.03 * 0.35);
}

TEST_CASE("a chain of meshes that are not changed is exact") {
  const Mesh first = with_height(test::torus(2, 0.7, 20, 12));
  Mesh same = first;
  write_source_points(same, closest_source_points(first, first));
  auto places = places_of(same, first);
  for (int i = 0; i < 5; ++i) places = compose_source_points(first, places, same, places);
  Mesh last = first;
  last.vertex_columns.columns.clear();
  carry_columns(first, places, last);
  CHECK(last.vertex_columns.find("height")->values == first.vertex_columns.find("height")->values);
}

TEST_CASE("texture coordinates stay on one side of a seam, and are those of the place") {
  const double major = 2;
  const Mesh first = with_texture(test::torus(major, 0.7, 60, 30), major);
  for (const double edge : {0.1, 0.25, 0.5}) {
    Mesh last = remeshed(first, edge);
    carry_columns(first, places_of(last, first), last);
    const Column& column = *last.face_columns.find("texcoord");
    REQUIRE(column.values.size() == 6 * last.faces.size());
    std::size_t beyond = 0;
    for (std::size_t f = 0; f < last.faces.size(); ++f)
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double* at = column.values.data() + 6 * f + axis;
        CHECK(std::max({at[0], at[2], at[4]}) - std::min({at[0], at[2], at[4]}) < 0.3);
        for (std::size_t i = 0; i < 3; ++i) {
          const auto turns = turns_of(last.positions[last.faces[f][i]], major);
          const double truth = axis == 0 ? turns.first : turns.second;
          const double off = std::remainder(at[2 * i] - truth, 1);
          // A corner beyond a seam takes the nearest point before the seam, at 0 or 1.
          const bool is_at_seam = at[2 * i] < 1e-9 || at[2 * i] > 1 - 1e-9;
          beyond += is_at_seam && std::abs(off) > 0.001;
          CHECK(std::abs(off) < (is_at_seam ? 0.2 : 0.03));
        }
      }
    CHECK(beyond > 0);
  }
}

TEST_CASE("faces take the numbers of the face at their middle; names choose") {
  Mesh first = with_height(test::cube());
  Column& side = first.face_columns.get("side", Scalar::int32, first.faces.size());
  for (Index f = 0; f < first.faces.size(); ++f) {
    const Vec3 normal = face_normal(first, f).normalized();
    side.values[f] = std::round(normal.dot(Vec3(1, 2, 3)));
  }
  Mesh last = first;
  RemeshOptions options;
  options.min_edge = 0.07;
  options.max_edge = 0.15;
  options.feature_angle_deg = 60;
  remesh(last, options);
  last.vertex_columns.columns.clear();
  last.face_columns.columns.clear();
  const auto places = closest_source_points(first, last);
  carry_columns(first, places, last, {"side"});
  CHECK(last.vertex_columns.columns.empty());
  const std::vector<double>& values = last.face_columns.find("side")->values;
  for (Index f = 0; f < last.faces.size(); ++f)
    CHECK(values[f] == std::round(face_normal(last, f).normalized().dot(Vec3(1, 2, 3))));
  CHECK_THROWS_AS(carry_columns(first, places, last, {"weight"}), InputError);
}

namespace {

/// Three boxes with corners on a grid, so that they share planes, rotated together. Every face has
/// its number as `id`. The texture coordinates of a corner are the number of the face and the
/// corner's position.
Mesh numbered_boxes(test::Random& random) {
  Mesh mesh;
  for (int box = 0; box < 3; ++box) {
    const Vec3 low = random.point(0, 3).array().floor();
    const Vec3 size = random.point(1, 3).array().floor();
    const Mesh added = test::cuboid(low, low + size);
    mesh = box == 0 ? added : test::joined(mesh, added);
  }
  const Eigen::AngleAxisd turn(random.uniform(0, 3), Vec3(1, 2, 3).normalized());
  for (Vec3& position : mesh.positions) position = turn * position;
  Column& id = mesh.face_columns.get("id", Scalar::int32, mesh.faces.size());
  Column texture{"texcoord", Scalar::float64, {}, Scalar::uint8, {0}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    id.values[f] = static_cast<double>(f);
    for (const Index corner : mesh.faces[f]) {
      const Vec3& at = mesh.positions[corner];
      texture.values.insert(texture.values.end(), {id.values[f], at.x(), at.y(), at.z()});
    }
    texture.list_offsets.push_back(texture.values.size());
  }
  mesh.face_columns.columns.push_back(texture);
  return mesh;
}

/// Splits each face in three at its center.
Mesh in_thirds(const Mesh& mesh) {
  Mesh thirds{mesh.positions, {}, {}, {}};
  for (const auto& [a, b, c] : mesh.faces) {
    const auto middle = static_cast<Index>(thirds.positions.size());
    thirds.positions.emplace_back((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3);
    thirds.faces.insert(thirds.faces.end(), {{a, b, middle}, {b, c, middle}, {c, a, middle}});
  }
  return thirds;
}

/// Checks that faces lie on the faces of the first mesh that they refer to, with the same
/// orientation.
void check_faces_lie_on_theirs(const Mesh& first, const Mesh& mesh) {
  const std::vector<double>& id = mesh.face_columns.find("id")->values;
  const std::vector<double>& texture = mesh.face_columns.find("texcoord")->values;
  REQUIRE(texture.size() == 12 * mesh.faces.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = first.faces[static_cast<Index>(id[f])];
    const Vec3 normal = face_normal(mesh, f);
    if (normal.norm() < 1e-9) continue;  // rounding may give a sliver any normal
    CHECK(normal.normalized().dot(face_normal(first, static_cast<Index>(id[f])).normalized()) >
          1 - 1e-6);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& corner = mesh.positions[mesh.faces[f][i]];
      const TrianglePoint nearest = closest_point_of_triangle(
          corner, first.positions[a], first.positions[b], first.positions[c]);
      CHECK((nearest.point - corner).norm() < 1e-9);
      const double* values = texture.data() + 12 * f + 4 * i;
      CHECK(values[0] == Approx(id[f]));
      CHECK((Vec3(values[1], values[2], values[3]) - corner).norm() < 1e-9);
    }
  }
}

}  // namespace

TEST_CASE("faces of boxes that share planes come from the face that they lie on, by brute force") {
  for (const int seed : {1, 2, 39}) {
    test::Random random(seed);
    for (int trial = 0; trial < 40; ++trial) {
      const Mesh first = numbered_boxes(random);
      Mesh between = cleaned(first);
      const std::vector<double> own = between.face_columns.find("id")->values;
      const SourcePoints on_first = places_of(between, first);
      carry_columns(first, on_first, between);
      // Cleaning itself carries numbers of faces from faces to pieces.
      CHECK(between.face_columns.find("id")->values == own);
      check_faces_lie_on_theirs(first, between);

      Mesh last = in_thirds(between);
      const SourcePoints on_last =
          compose_source_points(first, on_first, between, closest_source_points(between, last));
      carry_columns(first, on_last, last);
      check_faces_lie_on_theirs(first, last);
    }
  }
}
