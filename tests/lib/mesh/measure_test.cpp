#include "transformesh/measure.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/shapes.h"
#include "mesh/adjacency.h"
#include "mesh/local_measures.h"

using namespace transformesh;
using doctest::Approx;
using std::numbers::pi;

TEST_CASE("a cube has its exact measures") {
  const Mesh mesh = test::cuboid({1, 2, 3}, {2, 4, 6});
  CHECK(surface_area(mesh) == Approx(22).epsilon(1e-14));
  CHECK(volume(mesh) == Approx(6).epsilon(1e-14));
  CHECK(volume(test::reversed(mesh)) == Approx(-6).epsilon(1e-14));
  const Box box = bounding_box(mesh);
  CHECK(box.min() == Vec3(1, 2, 3));
  CHECK(box.max() == Vec3(2, 4, 6));
  CHECK(diagonal_of(box) == Approx(std::sqrt(14.0)));

  const EdgeLengths unit = edge_lengths(test::cube());
  CHECK(unit.count == 18);
  CHECK(unit.minimum == 1);
  CHECK(unit.maximum == std::sqrt(2.0));
  CHECK(unit.mean == Approx((12 + 6 * std::sqrt(2.0)) / 18));
  CHECK(angles(test::cube()).minimum_deg == Approx(45));
  CHECK(angles(test::cube()).minimum_mean_deg == Approx(45));
}

TEST_CASE("spheres and tori converge with the square of the edge length") {
  double last_area = 0;
  double last_volume = 0;
  for (int subdivision = 2; subdivision <= 5; ++subdivision) {
    const Mesh sphere = test::icosphere(subdivision);
    const double area_error = 4 * pi - surface_area(sphere);
    const double volume_error = 4 * pi / 3 - volume(sphere);
    CHECK(area_error > 0);
    if (subdivision > 2) {
      CHECK(last_area / area_error == Approx(4).epsilon(0.05));
      CHECK(last_volume / volume_error == Approx(4).epsilon(0.05));
    }
    last_area = area_error;
    last_volume = volume_error;
  }
  const Mesh torus = test::torus(2, 0.5, 400, 100);
  CHECK(surface_area(torus) == Approx(4 * pi * pi * 2 * 0.5).epsilon(1e-3));
  CHECK(volume(torus) == Approx(2 * pi * pi * 2 * 0.25).epsilon(1e-3));
}

TEST_CASE("the volume does not depend on where the mesh lies") {
  const Mesh sphere = test::icosphere(3);
  const Mesh far = test::moved(sphere, Vec3(1048576, -1048576, 2097152));
  CHECK(volume(far) == Approx(volume(sphere)).epsilon(1e-8));
}

TEST_CASE("the box ignores vertices without faces, unless there are no faces") {
  Mesh mesh = test::cube();
  mesh.positions.emplace_back(50, 50, 50);
  CHECK(bounding_box(mesh).max() == Vec3(1, 1, 1));
  mesh.faces.clear();
  CHECK(bounding_box(mesh).max() == Vec3(50, 50, 50));
  CHECK(diagonal_of(bounding_box(Mesh{})) == 0);
}

TEST_CASE("degenerate faces have angle zero and area zero") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 4}};
  CHECK(angles(mesh).minimum_deg == Approx(45));
  for (const Face& face : {Face{0, 1, 2}, Face{0, 1, 3}, Face{0, 1, 1}, Face{0, 0, 0}}) {
    mesh.faces = {face};
    CHECK(angles(mesh).minimum_deg == 0);
    CHECK(surface_area(mesh) == 0);
  }
  CHECK(angles(Mesh{}).minimum_mean_deg == 0);
  CHECK(edge_lengths(Mesh{}).mean == 0);
}

TEST_CASE("angles of a 3-4-5 triangle and of slivers") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {4, 1e-9, 0}};
  mesh.faces = {{0, 1, 2}};
  CHECK(angles(mesh).minimum_deg == Approx(std::atan2(3, 4) * 180 / pi));
  mesh.faces = {{0, 1, 3}};
  CHECK(angles(mesh).minimum_deg == Approx(2.5e-10 * 180 / pi));
}

TEST_CASE("vertex normals weigh by angle, not by how a side is cut") {
  const auto normals = vertex_normals(test::cube());
  for (int i = 0; i < 8; ++i) {
    const Vec3 outwards(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    CHECK((normals[i] - outwards.normalized()).norm() < 1e-15);
  }
  const Mesh sphere = test::icosphere(4);
  const auto sphere_normals = vertex_normals(sphere);
  const VertexFaces faces_at(sphere);
  for (Index v = 0; v < sphere_normals.size(); ++v)
    CHECK(vertex_normal(sphere, v, faces_at[v]) == sphere_normals[v]);
  for (std::size_t v = 0; v < sphere.positions.size(); ++v)
    CHECK((sphere_normals[v] - sphere.positions[v]).norm() < 5e-3);
  Mesh lonely;
  lonely.positions = {{1, 2, 3}};
  CHECK(vertex_normals(lonely)[0] == Vec3::Zero());
}

TEST_CASE("measures of tiny and of huge meshes are those of the mesh, scaled") {
  const Mesh mesh = test::torus(2, 0.5, 24, 12);
  for (const double scale : {1e-300, 1e-160, 1e-70, 1e70, 1e100, 1e155, 1e300}) {
    const Mesh scaled = test::scaled(mesh, scale);
    CHECK(diagonal_of(bounding_box(scaled)) == Approx(diagonal_of(bounding_box(mesh)) * scale));
    CHECK(edge_lengths(scaled).mean == Approx(edge_lengths(mesh).mean * scale));
    CHECK(edge_lengths(scaled).maximum == Approx(edge_lengths(mesh).maximum * scale));
    CHECK(angles(scaled).minimum_deg == Approx(angles(mesh).minimum_deg));
    if (scale < 1e150) CHECK(surface_area(scaled) == Approx(surface_area(mesh) * scale * scale));
    if (scale < 1e100) CHECK(volume(scaled) == Approx(volume(mesh) * scale * scale * scale));
    if (scale > 1e160) CHECK(std::isinf(surface_area(scaled)));
    if (scale > 1e110) CHECK(std::isinf(volume(scaled)));
  }
}

TEST_CASE("vertex normals of tiny and of huge meshes are unit") {
  for (const double scale : {1e-300, 1e-100, 1e-30, 1e30, 1e100, 1e300})
    for (const Vec3& normal : vertex_normals(test::scaled(test::icosphere(1), scale)))
      CHECK(normal.norm() == Approx(1));
}

TEST_CASE("valence six is counted over interior vertices") {
  CHECK(valence_six_share(test::torus(2, 0.5, 9, 6)) == 1);
  CHECK(valence_six_share(test::icosphere(0)) == 0);
  CHECK(valence_six_share(test::icosphere(2)) == Approx(150.0 / 162));
  CHECK(valence_six_share(test::grid(3)) == 1);
  CHECK(valence_six_share(Mesh{}) == 0);
}

TEST_CASE("means over halfedges count an inner edge twice, at its ends too") {
  const Mesh closed = test::tetrahedron();
  const double root = std::sqrt(2);
  const HalfedgeLengths lengths = halfedge_lengths(closed);
  CHECK(lengths.mean == Approx((1 + root) / 2));
  CHECK(lengths.maximum == Approx(root));
  CHECK(lengths.vertex_mean[0] == Approx(1));
  CHECK(lengths.vertex_mean[1] == Approx((1 + 2 * root) / 3));

  // Four border edges and one diagonal, which vertices 0 and 3 share.
  Mesh open = test::grid(1);
  open.positions.emplace_back(5, 5, 5);
  const HalfedgeLengths square = halfedge_lengths(open);
  CHECK(square.mean == Approx((4 + 2 * root) / 6));
  CHECK(square.vertex_mean[0] == Approx((2 + 2 * root) / 4));
  CHECK(square.vertex_mean[1] == Approx(1));
  CHECK(square.vertex_mean[4] == 0);
  CHECK(halfedge_lengths(Mesh{}).mean == 0);
}

TEST_CASE("the box of a mesh without vertices is the origin") {
  CHECK(bounding_box(Mesh()).min() == Vec3::Zero());
  CHECK(bounding_box(Mesh()).max() == Vec3::Zero());
  CHECK(diagonal_of(bounding_box(Mesh())) == 0);
}
