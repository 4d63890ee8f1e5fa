#include "reconstruction/surface_doubt.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/ball_photographs.h"
#include "helpers/shapes.h"
#include "views/photo/photo_scene.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

constexpr double least_cosine = 0.1;

const PhotoScene& scene() {
  static const PhotoScene scene = photo_scene(ring(), 1);
  return scene;
}

SurfaceDoubt doubt_of(const Mesh& mesh) { return surface_doubt(mesh, scene(), least_cosine); }

Mesh with_part(Mesh mesh, const Mesh& part) {
  const auto offset = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (const auto& [a, b, c] : part.faces)
    mesh.faces.push_back({a + offset, b + offset, c + offset});
  return mesh;
}

/// Adds a flat ellipsoid in front of the ball, perpendicular to the z axis. The axis of the ring of
/// cameras is y.
Mesh with_plate(const Mesh& mesh, double half_thickness) {
  Mesh plate = icosphere(3);
  for (Vec3& p : plate.positions) p = Vec3(0.3 * p.x(), 0.3 * p.y(), 1.25 + half_thickness * p.z());
  return with_part(mesh, plate);
}

}  // namespace

TEST_CASE("only parts of the true surface that no two views observe are doubtful") {
  Mesh mesh = ball(1);
  const SurfaceDoubt doubt = doubt_of(mesh);
  CHECK(doubt.places.empty());
  CHECK(doubt.share == 0);
  CHECK(doubt.disagreement < 0.06);
  set_doubt_column(mesh, doubt);
  const Column& column = *mesh.vertex_columns.find("doubt");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    CHECK((column.values[v] == 1 || column.values[v] < 0.5));
    // The cameras of the ring point at the equator.
    if (std::abs(mesh.positions[v].y()) < 0.3) CHECK(column.values[v] < 0.3);
  }
}

TEST_CASE("a plate that photographs do not show is found, and a thin one reported as thin") {
  for (const double half_thickness : {0.02, 0.2}) {
    const SurfaceDoubt doubt = doubt_of(with_plate(ball(1), half_thickness));
    REQUIRE_FALSE(doubt.places.empty());
    const DoubtfulPlace& place = doubt.places.front();
    CHECK((place.center - Vec3(0, 0, 1.25)).norm() < 0.3);
    CHECK(place.area > 100);
    CHECK(place.is_thin == (half_thickness < 0.1));
    CHECK_FALSE(place.has_handle);
    CHECK(doubt.share > 0.005);
    CHECK(in_words(place).find(" square pixels") != std::string::npos);
  }
}

TEST_CASE("a handle that photographs do not show is found") {
  Mesh mesh = ball(1);
  Mesh ring = torus(0.3, 0.1, 40, 20);
  for (Vec3& position : ring.positions) position.z() += 1.3;
  const SurfaceDoubt doubt = doubt_of(with_part(mesh, ring));
  REQUIRE_FALSE(doubt.places.empty());
  CHECK(doubt.places.front().has_handle);
  CHECK(in_words(doubt.places.front()).find(", with a handle)") != std::string::npos);
}

TEST_CASE("a surface that is too small is doubtful where it is visible") {
  const SurfaceDoubt doubt = doubt_of(ball(0.8));
  CHECK(doubt.disagreement > 0.4);
  CHECK(doubt.share > 0.4);
}

TEST_CASE("a groove that hardly spans a window is found by small windows") {
  Mesh mesh = icosphere(5);
  CHECK(doubt_of(mesh).small_window_share < 0.01);
  // A pixel is 0.019 wide. The axis of the ring of cameras is y.
  for (Vec3& p : mesh.positions)
    if (std::abs(p.y()) < 0.03) p *= 0.8;
  const SurfaceDoubt doubt = doubt_of(mesh);
  CHECK(doubt.share < 0.03);
  CHECK(doubt.small_window_share > 0.04);
  REQUIRE_FALSE(doubt.small_window_places.empty());
  CHECK(std::abs(doubt.small_window_places.front().center.y()) < 0.03);
}

TEST_CASE("a thin part is an unobserved fin unless two views observe one of its sides") {
  constexpr double pixel = 0.01;
  for (const double half_thickness : {0.02, 0.2}) {
    Mesh mesh = icosphere(4);
    for (Vec3& p : mesh.positions) p.z() *= half_thickness;
    std::vector<WindowSums> sums(mesh.positions.size());
    CHECK(unobserved_fins(mesh, sums, pixel).size() == (half_thickness < 0.1 ? 1 : 0));
    for (std::size_t v = 0; v < sums.size(); ++v)
      if (mesh.positions[v].z() > 0) sums[v].weight = 1;
    CHECK(unobserved_fins(mesh, sums, pixel).empty());
  }
}

TEST_CASE("both sides of a film with an observed rim are unobserved fins") {
  Mesh mesh = icosphere(5);
  std::vector<WindowSums> sums;
  for (Vec3& p : mesh.positions) {
    sums.push_back({std::hypot(p.x(), p.y()) > 0.8 ? 1.0 : 0.0, 0, 0});
    p.z() *= 0.02;
  }
  CHECK(unobserved_fins(mesh, sums, 0.01).size() == 2);
}

TEST_CASE("an unobserved gap is no fin, and an observed part has none") {
  Mesh other = ball(1);
  for (Vec3& p : other.positions) p.z() += 2.02;
  const Mesh mesh = with_part(ball(1), other);
  CHECK(unobserved_fins(mesh, std::vector<WindowSums>(mesh.positions.size()), 0.1).empty());
  CHECK(
      unobserved_fins(mesh, std::vector<WindowSums>(mesh.positions.size(), {1, 0, 0}), 1).empty());
}

TEST_CASE("a thin plate outside of all images is reported as an unobserved fin") {
  Mesh plate = icosphere(3);
  for (Vec3& p : plate.positions) p = Vec3(0.3 * p.x(), 1.8 + 0.02 * p.y(), 0.3 * p.z());
  CHECK(doubt_of(ball(1)).unobserved_fins.empty());
  const SurfaceDoubt doubt = doubt_of(with_part(ball(1), plate));
  REQUIRE(doubt.unobserved_fins.size() == 1);
  CHECK((doubt.unobserved_fins.front().center - Vec3(0, 1.8, 0)).norm() < 0.01);
}

TEST_CASE("a part of the ball behind a plate is hidden, the poles that no view faces are not") {
  const SurfaceDoubt before = doubt_of(ball(1));
  CHECK(before.hidden_places.empty());
  CHECK(before.hidden_share == 0);
  CHECK(*std::ranges::max_element(before.of_vertex) == 1);
  const SurfaceDoubt doubt = doubt_of(with_plate(ball(1), 0.2));
  REQUIRE_FALSE(doubt.hidden_places.empty());
  const DoubtfulPlace& place = doubt.hidden_places.front();
  CHECK((place.center - Vec3(0, 0, 1)).norm() < 0.1);
  CHECK(place.area > 25);
  CHECK(doubt.hidden_share > 0.001);
}
