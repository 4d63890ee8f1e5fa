/// Places where repair failed: what is counted there, nearby and far away.
#include "tm/clean/rounding/trouble_spots.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

namespace transformesh {
namespace {

// Each face its own source.
Assembly assembly_of(const Mesh& mesh) {
  Assembly assembly;
  assembly.mesh = mesh;
  for (Index f = 0; f < mesh.faces.size(); ++f) assembly.source_face.push_back(f);
  return assembly;
}

}  // namespace

TEST_CASE("failures count where faces overlap, whatever mesh they are of, and not elsewhere") {
  const Mesh near = test::cube(), far = test::moved(test::cube(), Vec3(5, 0, 0));
  const Mesh both = test::joined(near, far);
  const auto faces = static_cast<Index>(near.faces.size());
  TroubleSpots spots(both);
  for (Index f = 0; f < both.faces.size(); ++f) CHECK(spots.failures_at(both, f) == 0);
  CHECK(spots.most_failures() == 0);

  spots.add(assembly_of(both), {0});
  CHECK(spots.most_failures() == 1);
  CHECK(spots.failures_at(near, 0) == 1);
  for (Index f = 0; f < faces; ++f) CHECK(spots.failures_at(far, f) == 0);

  spots.add(assembly_of(both), {0, faces});
  CHECK(spots.failures_at(both, 0) == 2);
  CHECK(spots.failures_at(both, faces) == 1);
  CHECK(spots.most_failures() == 2);
}

TEST_CASE("faces added at once count once; the input faces that they come from are remembered") {
  const Mesh mesh = test::cube();
  Assembly assembly = assembly_of(mesh);
  assembly.source_face[1] = 7;
  TroubleSpots spots(mesh);
  spots.add(assembly, {0, 1});  // the two halves of one side: their boxes are the same
  CHECK(spots.failures_at(mesh, 0) == 1);
  CHECK(spots.failures_of_input()[0] == 1);
  CHECK(spots.failures_of_input()[1] == 0);
  CHECK(spots.failures_of_input()[7] == 1);
}

}  // namespace transformesh
