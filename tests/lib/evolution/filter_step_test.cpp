#include "evolution/filter_step.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"
#include "transformesh/velocity.h"

using namespace transformesh;

namespace {

/// A filter that changes the mesh in the bytes.
MeshFilter changing(const std::function<void(Mesh&)>& change) {
  return [change](const std::string& bytes) {
    Document document = read_mesh(bytes, "mesh").document;
    change(document.mesh);
    return write_mesh(document).bytes;
  };
}

DisplaceResult stepped(Mesh& mesh, const std::function<void(Mesh&)>& change) {
  return step_through(changing(change), Scalar::float64)(mesh, Progress());
}

void add_velocities(Mesh& mesh) {
  for (const char* name : {"vx", "vy", "vz"})
    for (double& value :
         mesh.vertex_columns.get(name, Scalar::float64, mesh.positions.size()).values)
      value = 0.01;
}

}  // namespace

TEST_CASE("vertices that a filter moves have moved, and columns that it adds stay") {
  Mesh mesh = test::cube();
  const DisplaceResult result = stepped(mesh, [](Mesh& inner) {
    inner.positions[3] += Vec3(3, 4, 0);
    inner.vertex_columns.get("heat", Scalar::float32, 8).values[2] = 0.5;
  });
  CHECK(result.moved == 1);
  CHECK(result.max_displacement == doctest::Approx(5));
  CHECK(mesh.positions[3] == test::cube().positions[3] + Vec3(3, 4, 0));
  REQUIRE(mesh.vertex_columns.find("heat") != nullptr);
  CHECK(mesh.vertex_columns.find("heat")->values[2] == 0.5);
}

TEST_CASE("velocities that a filter writes move vertices as displace() does, and do not stay") {
  Mesh expected = test::icosphere(2);
  const std::vector<Vec3> velocities(expected.positions.size(), Vec3(0.01, 0.01, 0.01));
  displace(expected, velocities);
  Mesh mesh = test::icosphere(2);
  const DisplaceResult result = stepped(mesh, add_velocities);
  CHECK(mesh.positions == expected.positions);
  CHECK(result.moved == mesh.positions.size());
  CHECK(mesh.vertex_columns.columns.empty());
}

TEST_CASE("moved vertices take precedence over velocities") {
  Mesh mesh = test::cube();
  add_velocities(mesh);
  const DisplaceResult result = stepped(mesh, [](Mesh& inner) { inner.positions[0].x() -= 1; });
  CHECK(result.moved == 1);
  CHECK(mesh.vertex_columns.columns.size() == 3);
}

TEST_CASE("a filter that changes more than positions is refused") {
  Mesh mesh = test::cube();
  CHECK_THROWS_AS(stepped(mesh, [](Mesh& inner) { inner.faces.pop_back(); }), InputError);
  CHECK_THROWS_AS(stepped(mesh, [](Mesh& inner) { inner = test::tetrahedron(); }), InputError);
  const Step empty =
      step_through([](const std::string&) { return std::string(); }, Scalar::float64);
  CHECK_THROWS_AS(empty(mesh, Progress()), InputError);
}
