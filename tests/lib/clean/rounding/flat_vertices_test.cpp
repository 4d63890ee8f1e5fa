/// Vertices are removed where the surface is flat, and stay at corners, at creases and at crowded
/// places.
#include "clean/rounding/flat_vertices.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>

#include "clean/rounding/broken_faces.h"
#include "helpers/assembly_of.h"
#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

/// A cube with a vertex `height` above its face z = 0.
Assembly cube_with_vertex(double height) {
  Assembly assembly;
  Mesh& mesh = assembly.mesh;
  mesh = test::cube();
  const Face split = mesh.faces[0];
  const auto apex = static_cast<Index>(mesh.positions.size());
  const Vec3 middle =
      (mesh.positions[split[0]] + mesh.positions[split[1]] + mesh.positions[split[2]]) / 3;
  mesh.positions.push_back(middle + Vec3(0, 0, height));
  mesh.faces[0] = {split[0], split[1], apex};
  mesh.faces.push_back({split[1], split[2], apex});
  mesh.faces.push_back({split[2], split[0], apex});
  assembly.vertex_is_new.assign(mesh.positions.size(), 0);
  assembly.vertex_is_new.back() = 1;
  assembly.face_is_new.assign(mesh.faces.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) assembly.source_face.push_back(f < 12 ? f : 0);
  return assembly;
}

/// A cube with a spike on its first face, four times as high as wide.
Assembly cube_with_spike(double width) {
  Assembly assembly;
  Mesh& mesh = assembly.mesh;
  mesh = test::cube();
  const auto [a, b, c] = mesh.faces[0];
  const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
  const auto d = static_cast<Index>(mesh.positions.size()), e = d + 1, f = d + 2, top = d + 3;
  for (const Index corner : {a, b, c})
    mesh.positions.push_back(middle + width * (mesh.positions[corner] - middle));
  mesh.positions.push_back(middle + 4 * width * face_normal(mesh, 0).normalized());
  mesh.faces[0] = {a, b, d};
  for (const Face& face : std::initializer_list<Face>{{b, e, d},
                                                      {b, c, e},
                                                      {c, f, e},
                                                      {c, a, f},
                                                      {a, d, f},
                                                      {d, e, top},
                                                      {e, f, top},
                                                      {f, d, top}})
    mesh.faces.push_back(face);
  assembly.vertex_is_new.assign(mesh.positions.size(), 0);
  std::fill(assembly.vertex_is_new.begin() + d, assembly.vertex_is_new.end(), char{1});
  assembly.face_is_new.assign(mesh.faces.size(), 0);
  for (Index face = 0; face < mesh.faces.size(); ++face)
    assembly.source_face.push_back(face < 12 ? face : 0);
  return assembly;
}

/// A cube with a tower on its first face. The tower consists of `storeys` triangular prisms of
/// height `storey`.
Assembly cube_with_tower(double width, double storey, Index storeys) {
  Assembly assembly = cube_with_spike(width);
  Mesh& mesh = assembly.mesh;
  const Vec3 up = storey * face_normal(test::cube(), 0).normalized();
  const auto top = static_cast<Index>(mesh.positions.size() - 1), base = top - 3;
  mesh.positions.pop_back();
  mesh.faces.resize(mesh.faces.size() - 3);
  for (Index level = 1; level <= storeys; ++level)
    for (Index i = 0; i < 3; ++i) mesh.positions.push_back(mesh.positions[base + i] + level * up);
  for (Index level = 0; level < storeys; ++level)
    for (Index i = 0; i < 3; ++i) {
      const Index a = base + 3 * level + i, b = base + 3 * level + (i + 1) % 3;
      mesh.faces.push_back({a, b, b + 3});
      mesh.faces.push_back({b + 3, a + 3, a});
    }
  const Index roof = base + 3 * storeys;
  mesh.faces.push_back({roof, roof + 1, roof + 2});
  assembly.vertex_is_new.resize(mesh.positions.size(), 1);
  assembly.face_is_new.assign(mesh.faces.size(), 0);
  assembly.source_face.resize(mesh.faces.size(), 0);
  return assembly;
}

bool remove_all(Assembly& assembly, bool moves_input, Displacement& moved, double steps = 8) {
  const VertexGrids grids(assembly, Scalar::float64);
  const bool is_any = remove_flat_vertices(test::cube(), assembly, test::all_faces(assembly.mesh),
                                           steps, moves_input, grids, moved);
  drop_collapsed_faces(assembly);
  return is_any;
}

}  // namespace

TEST_CASE("a new vertex inside a flat face is removed, and all corners stay") {
  for (const double height : {0.0, 0x1p-53, -0x1p-53}) {
    CAPTURE(height);
    Assembly assembly = cube_with_vertex(height);
    Displacement moved;
    CHECK(remove_all(assembly, true, moved));
    CHECK(assembly.mesh.faces.size() == 12);
    CHECK(test::count(assembly.mesh).is_closed_and_oriented);
    CHECK(test::signed_volume(assembly.mesh) == doctest::Approx(1));
    CHECK(find_intersections(assembly.mesh).empty());
    CHECK(moved.length == doctest::Approx(std::abs(height)));
  }
}

TEST_CASE("a vertex higher than the tolerance stays") {
  Assembly assembly = cube_with_vertex(0x1p-40);
  Displacement moved;
  CHECK(!remove_all(assembly, true, moved));
  CHECK(assembly.mesh.faces.size() == 14);
  CHECK(moved.length == 0);
}

TEST_CASE("a spike with edges shorter than half the tolerance is removed") {
  const double steps = 0x1p20, step = 0x1p-55;  // the spacing is up to four times `step`
  Assembly assembly = cube_with_spike(steps * step / 16);
  Displacement moved;
  CHECK(remove_all(assembly, false, moved, steps));
  CHECK(assembly.mesh.faces.size() == 12);
  CHECK(find_intersections(assembly.mesh).empty());
  CHECK(moved.length > 0);
  CHECK(moved.length <= 4 * steps * step);
}

TEST_CASE("displacements of consecutive collapses add up") {
  const double steps = 0x1p20, storey = steps * 0x1p-55 / 4;
  const Index storeys = 6;
  Assembly assembly = cube_with_tower(4 * storey, storey, storeys);
  REQUIRE(test::count(assembly.mesh).is_closed_and_oriented);
  Displacement moved;
  CHECK(remove_all(assembly, false, moved, steps));
  double height = 0;
  const Vec3 up = face_normal(test::cube(), 0).normalized();
  for (const Vec3& p : assembly.mesh.positions)
    height = std::max(height, up.dot(p - test::cube().positions[test::cube().faces[0][0]]));
  // Only few faces are left of the tower, but its full height. Consecutive collapses have moved
  // faces by this height in total.
  CHECK(assembly.mesh.faces.size() == 14);
  CHECK(height == doctest::Approx(storeys * storey));
  CHECK(moved.length >= height);
}

TEST_CASE("input vertices are removed only if that is allowed") {
  Assembly assembly = cube_with_vertex(0);
  assembly.vertex_is_new.back() = 0;
  Displacement moved;
  CHECK(!remove_all(assembly, false, moved));
  CHECK(assembly.mesh.faces.size() == 14);
}

TEST_CASE("a vertex on a crease is removed along it, and the shape stays") {
  // The edge from a to b of a cube is split, so that its middle lies in two planes.
  Assembly assembly = cube_with_vertex(0);
  Mesh& mesh = assembly.mesh;
  mesh = test::cube();
  const Index a = mesh.faces[0][0], b = mesh.faces[0][1];
  const auto middle = static_cast<Index>(mesh.positions.size());
  mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
  std::vector<Face> faces;
  assembly.source_face.clear();
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Face face = mesh.faces[f];
    assembly.source_face.push_back(f);
    std::size_t at = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = face[i], to = face[(i + 1) % 3];
      if ((from == a && to == b) || (from == b && to == a)) at = i;
    }
    if (at == 3) {
      faces.push_back(face);
      continue;
    }
    const Index from = face[at], to = face[(at + 1) % 3], apex = face[(at + 2) % 3];
    faces.push_back({from, middle, apex});
    faces.push_back({middle, to, apex});
    assembly.source_face.push_back(f);
  }
  mesh.faces = faces;
  assembly.face_is_new.assign(faces.size(), 0);
  Displacement moved;
  REQUIRE(faces.size() == 14);
  CHECK(remove_all(assembly, true, moved));
  CHECK(mesh.faces.size() == 12);
  CHECK(test::signed_volume(mesh) == doctest::Approx(1));
  CHECK(test::count(mesh).is_closed_and_oriented);
}
