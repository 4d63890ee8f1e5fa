/// Notes about values that files hold and meshes do not.
#include "io/formats/finite_values.h"

#include <doctest/doctest.h>

#include <limits>

using namespace transformesh;

TEST_CASE("vertices that are not finite are dropped with their faces, and counted") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, nan, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  std::vector<std::string> notes;
  drop_points_not_finite(mesh, 2, "ply", notes);
  CHECK(mesh.positions.size() == 3);
  CHECK(mesh.faces == std::vector<Face>{{0, 1, 2}});
  CHECK(notes == std::vector<std::string>{
                     "ply: 1 vertex with a coordinate that is not finite dropped, and 3 faces that "
                     "use it"});
}

TEST_CASE("integers from 2^53 on are counted, as doubles may round them") {
  std::vector<std::string> notes;
  note_rounded_integers({0, -0x1p52, 0x1p53 - 1}, "field 'id'", "pcd", notes);
  CHECK(notes.empty());
  note_rounded_integers({0x1p53, 1, -0x1p60}, "field 'id'", "pcd", notes);
  CHECK(notes == std::vector<std::string>{
                     "pcd: 2 integers of field 'id' are 2^53 or larger, and may be rounded: "
                     "numbers are kept as doubles"});
  note_zeroed(2, "normal", "vtk", notes);
  CHECK(notes.back() == "vtk: 2 normals that are not finite become 0");
}
