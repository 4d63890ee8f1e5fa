/// The kept pieces as a mesh. Positions decide which vertices and faces belong to the input and
/// which are new.
#include "clean/stitch/assemble.h"

#include <doctest/doctest.h>

#include <map>

#include "clean/exterior/exterior.h"
#include "helpers/arrangement_facts.h"

using namespace transformesh;

namespace {

Assembly assembled(const Mesh& mesh) {
  const Arrangement arrangement = test::arranged(mesh);
  return assemble(mesh, arrangement, find_exterior_by_rays(arrangement, 1, Progress()));
}

double linear(const Vec3& p) { return 2 + 3 * p.x() - p.y() + 0.5 * p.z(); }

void number_rows(Mesh& mesh) {
  Column& value = mesh.vertex_columns.get("value", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    value.values[v] = linear(mesh.positions[v]);
  Column& number = mesh.face_columns.get("number", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) number.values[f] = static_cast<double>(f);
}

std::size_t count_marks(const std::vector<char>& marks) {
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
}

void check_rows(const Mesh& mesh, const Assembly& assembly) {
  const Mesh& result = assembly.mesh;
  const Column& value = *result.vertex_columns.find("value");
  for (std::size_t v = 0; v < result.positions.size(); ++v) {
    CHECK(value.values[v] == doctest::Approx(linear(result.positions[v])).epsilon(1e-12));
    CHECK((assembly.vertex_is_new[v] == 1) == (assembly.input_vertex[v] == no_index));
    if (assembly.input_vertex[v] != no_index)
      CHECK(mesh.positions[assembly.input_vertex[v]] == result.positions[v]);
  }
  const Column& number = *result.face_columns.find("number");
  for (Index f = 0; f < result.faces.size(); ++f) {
    const Index source = assembly.source_face[f];
    CHECK(number.values[f] == source);
    const Triangle piece = triangle_of(result, f), whole = triangle_of(mesh, source);
    if (!assembly.face_is_new[f]) CHECK(piece == whole);
    const Vec3 normal = normal_of(whole[0], whole[1], whole[2]);
    CHECK(normal.dot(normal_of(piece[0], piece[1], piece[2])) > 0);
    for (const Vec3& corner : piece)
      CHECK(std::abs(normal.normalized().dot(corner - whole[0])) < 1e-14);
  }
}

}  // namespace

TEST_CASE("vertices and faces have their source in the input, and columns follow") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    Mesh mesh = test::random_balls(seed, 4);
    number_rows(mesh);
    const Assembly assembly = assembled(mesh);
    check_rows(mesh, assembly);
    const test::Count count = test::count(assembly.mesh);
    CHECK(count.is_closed_and_oriented);
    CHECK(count.is_manifold);
    CHECK(!count.has_isolated_vertices);
    CHECK(assembly.copies == 0);
    CHECK(count_marks(assembly.face_is_new) > 0);
  }
}

TEST_CASE("whole faces and their vertices come first, in their order") {
  const Mesh mesh = test::random_balls(2, 3);
  const Assembly assembly = assembled(mesh);
  CHECK(std::is_sorted(assembly.face_is_new.begin(), assembly.face_is_new.end()));
  const auto whole = static_cast<std::ptrdiff_t>(count_marks(assembly.face_is_new));
  const auto first_new = assembly.source_face.end() - whole;
  CHECK(std::is_sorted(assembly.source_face.begin(), first_new));
  CHECK(std::is_sorted(assembly.vertex_is_new.begin(), assembly.vertex_is_new.end()));
}

TEST_CASE("touching cubes are separated: one copy for a vertex, two for an edge") {
  struct Case {
    Vec3 shift;
    std::size_t copies;
  };
  // The cubes share vertices where they touch, so only copies can separate them.
  for (const auto& [shift, copies] : {Case{{1, 1, 1}, 1}, Case{{1, 1, 0}, 2}, Case{{3, 0, 0}, 0}}) {
    CAPTURE(copies);
    Mesh mesh = test::joined(test::cube(), test::moved(test::cube(), shift));
    const WeldedMesh welded = weld(mesh);
    for (Face& face : mesh.faces)
      for (Index& v : face) v = welded.vertex_of[welded.point_of[v]];
    const Assembly assembly = assembled(mesh);
    CHECK(assembly.copies == copies);
    CHECK(assembly.split_edges == 0);
    CHECK(assembly.mesh.positions.size() == 16);
    const test::Count count = test::count(assembly.mesh);
    CHECK(count.is_manifold);
    CHECK(count.genera == std::vector<long>{0, 0});
    CHECK(count_marks(assembly.vertex_is_new) == 0);
  }
}

TEST_CASE("where both ends of a singular edge are one umbrella, each sheet gets a midpoint") {
  // Two cubes on a diagonal between two plates: the edge in which they touch ends in both plates.
  Mesh mesh = test::joined(test::cuboid({0, 0, 0}, {2, 2, 1}), test::cuboid({0, 0, 2}, {2, 2, 3}));
  mesh = test::joined(mesh, test::cuboid({0, 0, 1}, {1, 1, 2}));
  mesh = test::joined(mesh, test::cuboid({1, 1, 1}, {2, 2, 2}));
  const Assembly assembly = assembled(mesh);
  CHECK(assembly.split_edges == 1);
  const auto at_middle =
      std::count(assembly.mesh.positions.begin(), assembly.mesh.positions.end(), Vec3(1, 1, 1.5));
  CHECK(at_middle == 2);
  const test::Count count = test::count(assembly.mesh);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK(test::signed_volume(assembly.mesh) == doctest::Approx(4 + 4 + 2));
}
