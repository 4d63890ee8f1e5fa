/// Selections of which the answer is known.
#include "tm/mesh/select.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "tm/support/error.h"

namespace transformesh {

TEST_CASE("components are chosen by faces, area or volume") {
  const Mesh mesh = test::joined(test::icosphere(1), test::cuboid({5, 0, 0}, {8, 3, 3}));
  const auto has_ball = [&](const std::vector<bool>& keep) {
    CHECK(keep.front() != keep.back());
    return keep.front();
  };
  CHECK(has_ball(faces_of_largest(mesh, 1, ComponentSize::faces)));
  CHECK_FALSE(has_ball(faces_of_largest(mesh, 1, ComponentSize::area)));
  CHECK_FALSE(has_ball(faces_of_largest(test::reversed(mesh), 1, ComponentSize::volume)));
  CHECK_FALSE(has_ball(faces_of_at_least(mesh, 27 - 1e-9, ComponentSize::volume)));
  const auto both = faces_of_largest(mesh, 3, ComponentSize::area);
  CHECK(std::count(both.begin(), both.end(), true) == std::ssize(mesh.faces));
}

TEST_CASE("conditions on properties and boxes") {
  Mesh mesh = test::tetrahedron();
  mesh.face_columns.get("label", Scalar::int32, 4).values = {0, 1, 2, 3};
  mesh.vertex_columns.get("height", Scalar::float64, 4).values = {0, 0, 0, 1};
  using Mask = std::vector<bool>;
  CHECK(faces_where(mesh, "label>=2") == Mask{false, false, true, true});
  CHECK(faces_where(mesh, "label != 2") == Mask{true, true, false, true});
  CHECK(faces_where(mesh, "height < 1") == Mask{true, false, false, false});
  CHECK(faces_in_box(mesh, {{0, 0, 0}, {1, 1, 0.5}}) == Mask{true, false, false, false});
  for (const char* text : {"", "label", "label>", ">3", "label=>3", "label>3x"})
    CHECK_THROWS_AS(faces_where(mesh, text), UsageError);
  CHECK_THROWS_AS(faces_where(mesh, "none>0"), InputError);
}

}  // namespace transformesh
