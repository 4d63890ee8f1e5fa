/// Slivers are removed by flips, the surface stays closed, and nothing else changes.
#include "clean/rounding/slivers.h"

#include <doctest/doctest.h>

#include "clean/rounding/broken_faces.h"
#include "helpers/assembly_of.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// A cube with a point in one face, `height` away from an edge, so that the face contains a sliver.
Assembly cube_with_sliver(double height) {
  Assembly assembly;
  Mesh& mesh = assembly.mesh;
  mesh = test::cube();
  const Face split = mesh.faces[0];  // face 0 2 1 at the bottom, split at a point near its edge 0 2
  const auto apex = static_cast<Index>(mesh.positions.size());
  mesh.positions.emplace_back(height, 0.4, 0);
  mesh.faces[0] = {split[0], split[1], apex};
  mesh.faces.push_back({split[1], split[2], apex});
  mesh.faces.push_back({split[2], split[0], apex});
  assembly.vertex_is_new.assign(mesh.positions.size(), 0);
  assembly.face_is_new.assign(mesh.faces.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) assembly.source_face.push_back(f);
  return assembly;
}

}  // namespace

TEST_CASE("a sliver lower than the rule is flipped, a higher one stays") {
  Assembly low = cube_with_sliver(2 * spacing_at(0.4));
  Displacement moved;
  const VertexGrids grids(low, Scalar::float64);
  CHECK(flip_slivers(low, test::all_faces(low.mesh), 8, grids, moved));
  CHECK(moved.spacings == doctest::Approx(2));
  CHECK(test::count(low.mesh).is_closed_and_oriented);
  CHECK(low.mesh.faces.size() == 14);
  CHECK(test::signed_volume(low.mesh) == doctest::Approx(1));
  for (Index f = 0; f < low.mesh.faces.size(); ++f)
    CHECK(normal_of(low.mesh.positions[low.mesh.faces[f][0]],
                    low.mesh.positions[low.mesh.faces[f][1]],
                    low.mesh.positions[low.mesh.faces[f][2]])
              .norm() > 0.1);

  Assembly high = cube_with_sliver(8 * spacing_at(0.4));
  const Mesh before = high.mesh;
  CHECK(!flip_slivers(high, test::all_faces(high.mesh), 8, grids, moved));
  CHECK(high.mesh.faces == before.faces);
}

TEST_CASE("the limit height doubles with the grids of the vertices") {
  Assembly assembly = cube_with_sliver(8 * spacing_at(0.4));
  VertexGrids grids(assembly, Scalar::float64);
  grids.coarsen(assembly.mesh, {0});
  Displacement moved;
  CHECK(flip_slivers(assembly, test::all_faces(assembly.mesh), 8, grids, moved));
  CHECK(moved.spacings == doctest::Approx(8));
}

TEST_CASE("flat faces upon each other vanish") {
  Assembly assembly;
  Mesh& mesh = assembly.mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
  mesh.faces = {{0, 1, 2}, {1, 0, 2}};
  assembly.vertex_is_new.assign(3, 1);
  assembly.face_is_new.assign(2, 1);
  assembly.source_face = {0, 1};
  Displacement moved;
  flip_slivers(assembly, {0, 1}, 1, VertexGrids(assembly, Scalar::float64), moved);
  drop_collapsed_faces(assembly);
  CHECK(mesh.faces.empty());
}
