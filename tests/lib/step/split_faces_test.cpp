#include "step/split_faces.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

TEST_CASE("split faces have no long edge, and are the same closed surface") {
  test::Random random(4);
  for (int i = 0; i < 20; ++i) {
    Mesh mesh = test::cuboid(Vec3::Zero(), random.point(0.1, 3));
    for (Vec3& point : mesh.positions) point += random.point(0, 0.05);
    const Mesh before = mesh;
    const double longest = random.uniform(0.1, 0.7) * edge_lengths(mesh).maximum;
    CHECK(split_faces(mesh, longest));
    CHECK(edge_lengths(mesh).maximum <= longest);
    CHECK(check_manifold(mesh).is_closed());
    CHECK(check_manifold(mesh).is_oriented());
    CHECK(surface_area(mesh) == Approx(surface_area(before)));
    CHECK(volume(mesh) == Approx(volume(before)));
    for (std::size_t v = 0; v < before.positions.size(); ++v)
      CHECK(mesh.positions[v] == before.positions[v]);
    CHECK_FALSE(split_faces(mesh, longest));
  }
}

TEST_CASE("faces without long edges stay as they are") {
  Mesh mesh = test::icosphere(2);
  const Mesh before = mesh;
  CHECK_FALSE(split_faces(mesh, 1));
  CHECK(mesh.faces == before.faces);
  Mesh points{{Vec3::Zero(), Vec3(9, 0, 0)}, {}, {}, {}};
  CHECK_FALSE(split_faces(points, 1));
}
