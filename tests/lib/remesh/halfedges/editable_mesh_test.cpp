#include "remesh/halfedges/editable_mesh.h"

#include <string>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Returns the message with which a mesh is refused.
std::string refusal(const Mesh& mesh) {
  try {
    EditableMesh editable(mesh);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

Index some_edge(const EditableMesh& mesh, Random& random) {
  for (;;) {
    const auto h = static_cast<Index>(random.below(mesh.halfedge_slots()));
    if (mesh.has_halfedge(h)) return h;
  }
}

/// Applies legal operations in random order. Connectivity does not depend on positions, so these
/// are random, too.
void edit_at_random(EditableMesh& mesh, Random& random, int steps) {
  for (int step = 0; step < steps; ++step) {
    const Index h = some_edge(mesh, random);
    switch (random.below(3)) {
      case 0:
        mesh.split(h, random.point(-1, 1));
        break;
      case 1:
        if (mesh.can_collapse(h)) mesh.collapse(h, random.point(-1, 1), 0.5);
        break;
      default:
        if (mesh.can_flip(h)) mesh.flip(h);
    }
  }
}

}  // namespace

TEST_CASE("a mesh comes back as it was, with isolated vertices and columns") {
  Mesh mesh = icosphere(1);
  mesh.positions.emplace_back(5, 5, 5);
  mesh.vertex_columns.get("quality", Scalar::float32, mesh.positions.size()).values[3] = 7;
  mesh.face_columns.get("label", Scalar::int32, mesh.faces.size()).values[5] = 9;
  const Mesh back = EditableMesh(mesh).to_mesh();
  CHECK(is_same(mesh, back));
  CHECK(back.vertex_columns.find("quality")->values == mesh.vertex_columns.find("quality")->values);
  CHECK(back.face_columns.find("label")->values == mesh.face_columns.find("label")->values);
}

TEST_CASE("meshes that are no oriented manifolds are refused with face indices") {
  Mesh twice = tetrahedron();
  twice.faces.push_back(twice.faces[1]);
  CHECK(refusal(twice).find("faces 1 and 4") != std::string::npos);
  Mesh turned = tetrahedron();
  std::swap(turned.faces[2][0], turned.faces[2][1]);
  CHECK(refusal(turned).find("faces ") != std::string::npos);
  CHECK(refusal(turned).ends_with(": the mesh is not an oriented manifold"));

  Mesh touching = joined(tetrahedron(), tetrahedron());
  for (Face& face : touching.faces) {
    for (Index& v : face) v = v == 4 ? 0 : v;
  }
  CHECK(refusal(touching).find("vertex 0 joins 6 faces") != std::string::npos);

  Mesh beyond = tetrahedron();
  beyond.faces[3][1] = 44;
  CHECK(refusal(beyond).find("face 3 has vertex index 44, but there are 4") != std::string::npos);
  Mesh folded = tetrahedron();
  folded.faces[2][1] = folded.faces[2][0];
  CHECK(refusal(folded).find("face 2 uses vertex 0 twice") != std::string::npos);
}

TEST_CASE("a split keeps faces in place and appends") {
  EditableMesh mesh(tetrahedron());
  const Index v = mesh.split(0, Vec3(0.5, 0.5, 0.5));
  const Mesh split = mesh.to_mesh();
  CHECK(v == 4);
  CHECK(split.faces.size() == 6);
  CHECK(is_oriented_manifold(split));
  CHECK(is_closed(split));
  CHECK(mesh.valence(v) == 4);
}

TEST_CASE("a tetrahedron cannot lose an edge, nor flip one") {
  const EditableMesh mesh(tetrahedron());
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
    CHECK_FALSE(mesh.can_collapse(h));
    CHECK_FALSE(mesh.can_flip(h));
  }
}

TEST_CASE("a torus with three vertices around does not lose its hole") {
  // the ends of every edge around the hole have a common neighbor that forms no face with them
  const EditableMesh mesh(torus(2, 1, 3, 3));
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) CHECK_FALSE(mesh.can_collapse(h));
}

TEST_CASE("two border vertices do not merge across the inside") {
  const EditableMesh mesh(grid(1));
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
    if (!mesh.is_border(h)) CHECK_FALSE(mesh.can_collapse(h));
  }
}

TEST_CASE("random edits keep manifold, genus and border") {
  const Mesh shapes[] = {icosphere(2), torus(2, 1, 9, 7), grid(6), cube()};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Mesh& shape = shapes[seed % 4];
    EditableMesh mesh(shape);
    edit_at_random(mesh, random, 400);
    const Mesh edited = mesh.to_mesh();
    CAPTURE(seed);
    CHECK(is_oriented_manifold(edited));
    CHECK(is_closed(edited) == is_closed(shape));
    CHECK(euler_number(edited) == euler_number(shape));
    CHECK(is_same(EditableMesh(edited).to_mesh(), edited));
  }
}

TEST_CASE("columns follow splits, collapses and faces") {
  Mesh mesh = icosphere(0);
  Column& value = mesh.vertex_columns.get("value", Scalar::float64, 12);
  for (std::size_t v = 0; v < 12; ++v) value.values[v] = static_cast<double>(v);
  Column& label = mesh.face_columns.get("label", Scalar::int32, 20);
  for (std::size_t f = 0; f < 20; ++f) label.values[f] = static_cast<double>(f);

  EditableMesh editable(mesh);
  editable.split(0, Vec3(0, 1, 1));  // between 0 and 11
  Mesh split = editable.to_mesh();
  CHECK(split.vertex_columns.find("value")->values.back() == 5.5);
  CHECK(split.face_columns.find("label")->values[20] == 0);
  editable.collapse(0, Vec3(0, 1, 0), 0.25);  // vertex 0 is merged into the new one
  split = editable.to_mesh();
  CHECK(split.positions.size() == 12);
  CHECK(split.vertex_columns.find("value")->values.back() == doctest::Approx(0.75 * 5.5));
}
