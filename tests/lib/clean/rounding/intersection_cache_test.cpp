/// What is known of pairs of faces is what a search without memory finds.
#include "clean/rounding/intersection_cache.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "clean/rounding/broken_faces.h"
#include "helpers/assembly_of.h"
#include "helpers/random.h"
#include "helpers/shapes.h"

namespace transformesh {

TEST_CASE("a series of searches with a memory finds what each finds without one") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Assembly assembly = test::assembly_of(
        test::joined(test::icosphere(1), test::moved(test::icosphere(1), {0.3, 0.2, 0.1})));
    for (char& is_new : assembly.face_is_new) is_new = random.below(3) != 0 ? 1 : 0;
    IntersectionCache known;
    std::size_t intersections = 0;
    for (int round = 0; round < 6; ++round) {
      const BrokenFaces with = find_broken_faces(assembly, known);
      const BrokenFaces without = find_broken_faces(assembly);
      REQUIRE(with.faces == without.faces);
      REQUIRE(with.intersections == without.intersections);
      intersections += with.intersections.size();

      // Some vertices move, some faces turn, some go.
      Mesh& mesh = assembly.mesh;
      for (Vec3& p : mesh.positions)
        if (random.below(10) == 0) p += 0.1 * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0);
      for (Face& face : mesh.faces)
        if (random.below(10) == 0) face = {face[1], face[2], face[0]};
      const std::size_t last = mesh.faces.size() - 1, gone = random.below(last);
      std::swap(mesh.faces[gone], mesh.faces[last]);
      std::swap(assembly.face_is_new[gone], assembly.face_is_new[last]);
      mesh.faces.pop_back();
      assembly.face_is_new.pop_back();
    }
    CHECK(intersections > 100);
  }
}

TEST_CASE("pairs are known where their corners stay, and one of them was new") {
  const Mesh mesh = test::joined(test::tetrahedron(), test::moved(test::tetrahedron(), {5, 0, 0}));
  const auto is_at_last = [&](Index f) {
    return std::find(mesh.faces[f].begin(), mesh.faces[f].end(), 7) != mesh.faces[f].end();
  };
  Index whole = 4;
  while (is_at_last(whole)) ++whole;
  IntersectionCache known;
  known.begin(mesh);
  CHECK(!known.cross(0, whole).has_value());
  known.end(mesh, {1, 0, 0, 0, 0, 0, 0, 0}, {{0, 2}, {0, whole}});

  // The last vertex moves, and the first two faces change places.
  Mesh moved = mesh;
  moved.positions[7] += Vec3(1, 0, 0);
  std::swap(moved.faces[0], moved.faces[1]);
  known.begin(moved);
  CHECK(known.cross(1, whole) == true);
  CHECK(known.cross(whole, 1) == true);
  CHECK(known.cross(1, 2) == true);
  CHECK(known.cross(1, 3) == false);
  CHECK(!known.cross(0, whole).has_value());  // neither was new
  for (Index f = 4; f < 8; ++f)
    if (f != whole) CHECK(!known.cross(1, f).has_value());
}

}  // namespace transformesh
