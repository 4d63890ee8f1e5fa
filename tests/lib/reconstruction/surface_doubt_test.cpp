#include "reconstruction/surface_doubt.h"

#include <doctest/doctest.h>

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
