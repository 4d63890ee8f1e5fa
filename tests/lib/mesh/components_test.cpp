#include "transformesh/components.h"

#include <doctest/doctest.h>

#include <cmath>
#include <tuple>

#include "helpers/shapes.h"
#include "mesh/adjacency.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

TEST_CASE("Euler's formula gives the genus of each component") {
  const Mesh mesh = test::joined(test::joined(test::torus(2, 0.5, 20, 10), test::icosphere(2)),
                                 test::moved(test::cube(), Vec3(5, 5, 5)));
  const Components found = connected_components(mesh);
  REQUIRE(found.components.size() == 3);
  const auto& [torus, sphere, cube] =
      std::tie(found.components[0], found.components[1], found.components[2]);
  CHECK(torus.genus() == 1);
  CHECK(sphere.genus() == 0);
  CHECK(cube.genus() == 0);
  CHECK(torus.euler() == 0);
  CHECK(cube.euler() == 2);
  CHECK(torus.faces == 400);
  CHECK(sphere.vertices == 162);
  CHECK(cube.edges == 18);
  CHECK(sphere.volume == Approx(volume(test::icosphere(2))).epsilon(1e-12));
  CHECK(torus.volume + sphere.volume + cube.volume == Approx(volume(mesh)).epsilon(1e-12));
  CHECK(found.of_face[0] == 0);
  CHECK(found.of_face[400] == 1);
  CHECK(found.of_face.back() == 2);
}

TEST_CASE("components of a closed manifold are the same by its opposite halfedges") {
  const Mesh mesh = test::joined(test::joined(test::torus(2, 0.5, 20, 10), test::icosphere(2)),
                                 test::moved(test::cube(), Vec3(5, 5, 5)));
  const Components expected = connected_components(mesh);
  const Components found = connected_components(mesh, connect(opposite_halfedges(mesh)));
  CHECK(found.of_face == expected.of_face);
  REQUIRE(found.components.size() == expected.components.size());
  for (std::size_t i = 0; i < found.components.size(); ++i) {
    CHECK(found.components[i].vertices == expected.components[i].vertices);
    CHECK(found.components[i].edges == expected.components[i].edges);
    CHECK(found.components[i].faces == expected.components[i].faces);
    CHECK(found.components[i].boundary_loops == 0);
    CHECK(found.components[i].volume == expected.components[i].volume);
  }
}

TEST_CASE("the volume of a component is that of its mesh, at any size") {
  const Mesh box = test::cuboid({15, 20, 12}, {22, 27, 19});
  const Mesh boxes = test::joined(box, test::moved(box, {100, 3, 8}));
  for (const Component& component : connected_components(boxes).components)
    CHECK(component.volume == 343);
  for (const double factor : {1e-100, 1e-70, 1e70, 1e100}) {
    const Mesh scaled = test::scaled(box, factor);
    CHECK(connected_components(scaled).components[0].volume == volume(scaled));
    CHECK(std::isnormal(volume(scaled)));
  }
}

TEST_CASE("boundary loops count as caps") {
  CHECK(connected_components(test::grid(4)).components[0].boundary_loops == 1);
  CHECK(connected_components(test::grid(4)).components[0].genus() == 0);

  // Two holes in a torus.
  Mesh torus = test::torus(2, 0.5, 20, 10);
  torus.faces.erase(torus.faces.begin() + 100);
  torus.faces.erase(torus.faces.begin());
  const Components found = connected_components(torus);
  REQUIRE(found.components.size() == 1);
  CHECK(found.components[0].boundary_loops == 2);
  CHECK(found.components[0].genus() == 1);
}

TEST_CASE("holes that touch at a vertex have one common border") {
  // A grid without two cells that meet in a corner. There is one border around the grid, and one
  // around both holes, whose borders are joined by the umbrellas of the common corner.
  Mesh mesh = test::grid(4);
  std::vector<bool> keep(mesh.faces.size(), true);
  for (const int cell : {5, 10}) keep[2 * cell] = keep[2 * cell + 1] = false;
  const Mesh open = select_faces(mesh, keep);
  const Components found = connected_components(open);
  REQUIRE(found.components.size() == 1);
  CHECK(found.components[0].boundary_loops == 2);
}

TEST_CASE("components join across a shared vertex and are numbered by their first face") {
  Mesh mesh = test::joined(test::tetrahedron(), test::tetrahedron());
  CHECK(connected_components(mesh).components.size() == 2);
  for (std::size_t f = 4; f < 8; ++f)
    for (Index& vertex : mesh.faces[f])
      if (vertex == 4) vertex = 0;
  const Components found = connected_components(mesh);
  REQUIRE(found.components.size() == 1);
  CHECK(found.components[0].vertices == 7);
  CHECK(connected_components(Mesh{}).components.empty());
}

TEST_CASE("selected faces bring their vertices and columns in order") {
  Mesh mesh = test::joined(test::tetrahedron(), test::cube());
  Column& id = mesh.vertex_columns.get("id", Scalar::int32, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) id.values[v] = static_cast<double>(v);
  Column& label = mesh.face_columns.get("label", Scalar::uint8, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) label.values[f] = static_cast<double>(f);

  std::vector<bool> keep(mesh.faces.size(), false);
  keep[2] = keep[15] = true;  // face 15 uses vertices 7, 11, 9 of the joined mesh
  const Mesh part = select_faces(mesh, keep);
  CHECK(part.face_columns.find("label")->values == std::vector<double>{2, 15});
  CHECK(part.vertex_columns.find("id")->values == std::vector<double>{0, 2, 3, 7, 9, 11});
  REQUIRE(part.faces.size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
    for (int corner = 0; corner < 3; ++corner)
      CHECK(part.positions[part.faces[i][corner]] ==
            mesh.positions[mesh.faces[i == 0 ? 2 : 15][corner]]);
  CHECK(select_faces(mesh, std::vector<bool>(16, false)).positions.empty());
}
