/// Splitting faces at points: what is closed stays closed, areas and columns stay, edges come where
/// they are wanted.
#include "tm/clean/rounding/face_cuts.h"

#include <doctest/doctest.h>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "tm/mesh/digits.h"
#include "tm/mesh/measure.h"

namespace transformesh {
namespace {

/// A mesh of which nothing is new, with the number of each face.
Assembly assembly_of(const Mesh& mesh) {
  Assembly assembly;
  assembly.mesh = mesh;
  Column& number = assembly.mesh.face_columns.get("number", Scalar::int32, mesh.faces.size());
  for (Index v = 0; v < mesh.positions.size(); ++v) assembly.input_vertex.push_back(v);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    assembly.source_face.push_back(f);
    number.values[f] = f;
  }
  assembly.vertex_is_new.assign(mesh.positions.size(), 0);
  assembly.face_is_new.assign(mesh.faces.size(), 0);
  return assembly;
}

/// A new point, named by a number.
Index new_point(FaceCuts& cuts, Index number, const Vec3& position) {
  return cuts.point_between({number, number}, {number, number}, position);
}

bool has_edge(const Mesh& mesh, const Vec3& a, const Vec3& b) {
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &p = mesh.positions[f[i]], &q = mesh.positions[f[(i + 1) % 3]];
      if ((p == a && q == b) || (p == b && q == a)) return true;
    }
    return false;
  });
}

}  // namespace

TEST_CASE("points on edges and in faces become vertices of a surface that stays closed") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Mesh mesh = test::icosphere(2);
    const WeldedMesh welded = weld(mesh);
    Assembly assembly = assembly_of(mesh);
    FaceCuts cuts(assembly, welded, Scalar::float64);
    std::vector<char> is_cut(mesh.faces.size(), 0);
    Index points = 0;
    for (Index f = 0; f < mesh.faces.size(); f += 1 + static_cast<Index>(random.below(6))) {
      const Triangle t = cuts.triangle(f);
      if (random.below(2) == 0) {
        const double u = random.uniform(0.1, 0.4), v = random.uniform(0.1, 0.4);
        const Vec3 inside = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
        cuts.add_inside(f, new_point(cuts, points++, inside));
        is_cut[f] = 1;
      }
      const std::size_t i = random.below(3);
      const PointPair edge = edge_of(cuts.corners(f), i);
      const double share = random.uniform(0.1, 0.9);
      const Vec3 on_edge = (1 - share) * cuts.position(edge[0]) + share * cuts.position(edge[1]);
      cuts.add_on_edge(edge, share, new_point(cuts, points++, on_edge));
      for (Index g = 0; g < mesh.faces.size(); ++g)
        for (std::size_t k = 0; k < 3; ++k)
          if (edge_of(cuts.corners(g), k) == edge) is_cut[g] = 1;
    }
    cuts.split_faces(1e-12);

    const Mesh& result = assembly.mesh;
    const test::Count count = test::count(result);
    CHECK(count.is_closed_and_oriented);
    CHECK(count.is_manifold);
    CHECK(count.genera == std::vector<long>{0});
    CHECK(result.positions.size() == mesh.positions.size() + points);
    CHECK(surface_area(result) == doctest::Approx(surface_area(mesh)).epsilon(1e-12));
    CHECK(volume(result) == doctest::Approx(volume(mesh)).epsilon(1e-12));

    // Whole faces first, then the pieces, each with the row of the face that it comes from.
    const auto whole = static_cast<std::size_t>(std::count(is_cut.begin(), is_cut.end(), 0));
    const Column& number = *result.face_columns.find("number");
    for (std::size_t f = 0; f < result.faces.size(); ++f) {
      CHECK(assembly.face_is_new[f] == (f < whole ? 0 : 1));
      const Index source = assembly.source_face[f];
      CHECK(number.values[f] == source);
      CHECK(is_cut[source] == assembly.face_is_new[f]);
      if (f < whole) CHECK(result.faces[f] == mesh.faces[source]);
    }
    CHECK(std::count(assembly.vertex_is_new.begin(), assembly.vertex_is_new.end(), 1) == points);
  }
}

TEST_CASE("the edges of another face whose ends are on the face become edges of it") {
  // A small triangle close to the middle of a big one: its corners go inside, and its edges follow.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {1, 1, 1e-9}, {7, 1, 1e-9}, {1.5, 1.2, 1e-9}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  for (const bool is_constrained : {false, true}) {
    const WeldedMesh welded = weld(mesh);
    Assembly assembly = assembly_of(mesh);
    FaceCuts cuts(assembly, welded, Scalar::float64);
    for (const Index corner : cuts.corners(1)) cuts.add_inside(0, corner);
    if (is_constrained) cuts.constrain(0, 1);
    cuts.split_faces(1e-12);
    CHECK(assembly.mesh.faces.size() == 1 + 7);
    Mesh pieces = assembly.mesh;
    pieces.faces.erase(pieces.faces.begin());  // the small triangle itself
    const auto& p = mesh.positions;
    CHECK(has_edge(pieces, p[3], p[5]));
    CHECK(has_edge(pieces, p[4], p[5]));
    // Without being wanted, the long edge is no better than the other diagonal.
    if (is_constrained) CHECK(has_edge(pieces, p[3], p[4]));
  }
}

TEST_CASE("two edges have one point between them, rounded to the type of coordinates") {
  const Mesh mesh = test::cube();
  const WeldedMesh welded = weld(mesh);
  Assembly assembly = assembly_of(mesh);
  FaceCuts cuts(assembly, welded, Scalar::float32);
  const Vec3 position(0.1, 0.2, 0.3);
  const Index point = cuts.point_between({0, 1}, {2, 3}, position);
  CHECK(point == 8);
  CHECK(cuts.point_between({2, 3}, {0, 1}, Vec3(5, 5, 5)) == point);
  CHECK(cuts.point_between({0, 1}, {2, 4}, position) == point + 1);
  for (int i = 0; i < 3; ++i) CHECK(cuts.position(point)[i] == round_to_single(position[i]));
}

}  // namespace transformesh
