/// Decimated shapes, compared with the originals: counts, closed forms of volume and distance, and
/// no self-intersection.
#include "remesh/decimator.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "helpers/shapes.h"
#include "lib/remesh/double_cone.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/components.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

Mesh decimated(Mesh mesh, std::size_t faces, DecimateOptions options = {}) {
  const std::size_t before = mesh.faces.size();
  options.faces = faces;
  const DecimateResult result = decimate(mesh, options);
  CHECK(mesh.faces.size() == result.faces);
  CHECK(mesh.faces.size() <= faces);
  CHECK(mesh.faces.size() + 1 >= faces);
  CHECK(before - 2 * result.collapses == result.faces);
  CHECK(test::is_oriented_manifold(mesh));
  CHECK(test::is_closed(mesh));
  CHECK(find_intersections(mesh).empty());
  return mesh;
}

/// A cube whose sides are grids of squares, each split in two.
Mesh fine_cube(int steps) {
  Mesh mesh;
  std::map<std::array<int, 3>, Index> numbers;
  const auto number = [&](const std::array<int, 3>& p) {
    const auto [entry, is_new] = numbers.try_emplace(p, static_cast<Index>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(Vec3(p[0], p[1], p[2]) / steps);
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, steps}) {
      for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < steps; ++k) {
          const auto corner = [&](int di, int dk) {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = k + dk;
            return number(p);
          };
          Face first{corner(0, 0), corner(1, 0), corner(1, 1)};
          Face second{corner(0, 0), corner(1, 1), corner(0, 1)};
          if (side == 0) std::swap(first[1], first[2]), std::swap(second[1], second[2]);
          mesh.faces.push_back(first);
          mesh.faces.push_back(second);
        }
      }
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("a sphere keeps its shape with few faces") {
  const Mesh ball = test::icosphere(5);
  for (const std::size_t faces : {5000, 1000, 200, 40}) {
    CAPTURE(faces);
    const Mesh mesh = decimated(ball, faces);
    // n triangles of equal area lack the caps between them and the sphere, a fraction of about 7.3
    // / n of the volume.
    const double lost = 1 - volume(mesh) / (4.0 / 3 * std::numbers::pi);
    CHECK(lost > -1e-3);
    CHECK(lost < 11.0 / static_cast<double>(faces));
    // The center of an equilateral triangle with a share 1 / n of the sphere's area is 4.84 / n
    // inside the sphere.
    for (const Vec3& p : mesh.positions)
      CHECK(std::abs(p.norm() - 1) < 4.84 / static_cast<double>(faces));
  }
}

TEST_CASE("flat parts are decimated first: a fine cube becomes twelve triangles") {
  const Mesh mesh = decimated(fine_cube(12), 12);
  CHECK(mesh.positions.size() == 8);
  CHECK(volume(mesh) == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("flat sides stay flat at every number of faces, and no vertex leaves the cube") {
  // If `steps` is 2, each edge of the cube has a vertex in its middle. A corner that is merged with
  // this vertex must not leave the cube.
  for (const auto& [steps, faces] : {std::pair(2, 44), {2, 20}, {12, 1000}, {12, 100}, {12, 30}}) {
    CAPTURE(steps);
    CAPTURE(faces);
    const Mesh mesh = decimated(fine_cube(steps), static_cast<std::size_t>(faces));
    CHECK(volume(mesh) == doctest::Approx(1).epsilon(1e-12));
    for (const Vec3& p : mesh.positions)
      CHECK((p - Vec3::Constant(0.5)).cwiseAbs().maxCoeff() == doctest::Approx(0.5).epsilon(1e-12));
  }
}

TEST_CASE("hills of a millionth stay while there are flat faces") {
  Mesh mesh = fine_cube(20);
  std::vector<Vec3> hills;
  const auto is_chosen = [](double t) {
    return t > 0 && t < 1 && std::abs(std::remainder(t, 0.25)) < 1e-9;
  };
  for (Vec3& p : mesh.positions)
    if (p.x() == 1 && is_chosen(p.y()) && is_chosen(p.z())) {
      p.x() += 1e-6;
      hills.push_back(p);
    }
  REQUIRE(hills.size() == 9);
  const Mesh coarse = decimated(mesh, mesh.faces.size() / 4);
  for (const Vec3& hill : hills) {
    double nearest = 1;
    for (const Vec3& p : coarse.positions) nearest = std::min(nearest, (p - hill).norm());
    CHECK(nearest < 1e-12);
  }
}

TEST_CASE("the ends of a rod with long edges keep their shape") {
  // A rod 40 times as long as wide, in 80 slices. Its 32 sides are flat along the rod.
  constexpr int around = 32, slices = 80;
  Mesh rod;
  for (int slice = 0; slice <= slices; ++slice)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      rod.positions.emplace_back(std::cos(angle), std::sin(angle), slice);
    }
  const auto at = [](int slice, int i) { return static_cast<Index>(slice * around + i % around); };
  for (int slice = 0; slice < slices; ++slice)
    for (int i = 0; i < around; ++i) {
      rod.faces.push_back({at(slice, i), at(slice, i + 1), at(slice + 1, i + 1)});
      rod.faces.push_back({at(slice, i), at(slice + 1, i + 1), at(slice + 1, i)});
    }
  for (int i = 1; i + 1 < around; ++i) {
    rod.faces.push_back({at(0, 0), at(0, i + 1), at(0, i)});
    rod.faces.push_back({at(slices, 0), at(slices, i), at(slices, i + 1)});
  }
  // Two triangles for each of the sides, and 30 for each of the two ends.
  const Mesh mesh = decimated(rod, 124);
  CHECK(volume(mesh) == doctest::Approx(volume(rod)).epsilon(1e-9));
}

TEST_CASE("a double cone keeps its apexes, and becomes coarse around them") {
  const Mesh cone = test::double_cone(1000);
  const Mesh mesh = decimated(cone, 100);
  for (const Index apex : {1000U, 1001U})
    CHECK(std::any_of(mesh.positions.begin(), mesh.positions.end(),
                      [&](const Vec3& p) { return (p - cone.positions[apex]).norm() < 0.01; }));
  CHECK(volume(mesh) == doctest::Approx(volume(cone)).epsilon(0.01));
  decimated(cone, 8);
}

TEST_CASE("edges that are sharp stay where they are") {
  DecimateOptions options;
  options.feature_angle_deg = 40;
  const Mesh mesh = decimated(fine_cube(10), 60, options);
  CHECK(volume(mesh) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("handles and components stay") {
  const Mesh mesh = decimated(test::torus(1, 0.4, 60, 30), 60);
  CHECK(connected_components(mesh).components.front().genus() == 1);

  const Mesh pair = test::joined(test::icosphere(3), test::moved(test::icosphere(3), {3, 0, 0}));
  CHECK(connected_components(decimated(pair, 40)).components.size() == 2);
}

TEST_CASE("narrow faces beside a sharp edge are decimated") {
  // The faces of one apex are steep, those of the other apex are flat.
  Mesh cone = test::double_cone(600);
  cone.positions[600] *= 3;
  cone.positions[601] *= 0.2;
  CHECK(decimated(cone, 300).faces.size() <= 300);
}

TEST_CASE("close sheets do not intersect after decimation") {
  Mesh plate = test::icosphere(5);
  for (Vec3& p : plate.positions) p.z() *= 0.01;
  decimated(plate, 400);
}

TEST_CASE("positions are rounded before they are checked") {
  DecimateOptions options;
  options.coordinate = Scalar::float32;
  Mesh ball = test::icosphere(4);
  for (Vec3& p : ball.positions) p = p.cast<float>().cast<double>();
  for (const Vec3& p : decimated(ball, 300, options).positions)
    CHECK(p == Vec3(p.cast<float>().cast<double>()));
}

TEST_CASE("vertex properties are blended along") {
  Mesh ball = test::icosphere(4);
  Column& height = ball.vertex_columns.get("height", Scalar::float64, ball.positions.size());
  for (std::size_t v = 0; v < ball.positions.size(); ++v) height.values[v] = ball.positions[v].z();
  const Mesh mesh = decimated(ball, 500);
  const Column* column = mesh.vertex_columns.find("height");
  REQUIRE(column != nullptr);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK(std::abs(column->values[v] - mesh.positions[v].z()) < 0.1);
}
