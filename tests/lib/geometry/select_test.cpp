/// Combined conditions of selections.
#include "transformesh/select.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

TEST_CASE("faces that meet all conditions stay, or all others") {
  // A ball of radius 1 about the origin, one about (5, 0, 0), and a box.
  Mesh ball = test::icosphere(1);
  for (Vec3& position : ball.positions) position.x() += 5;
  const Mesh all =
      test::joined(test::joined(test::icosphere(1), ball), test::cuboid({9, 0, 0}, {12, 3, 3}));
  const std::size_t faces = ball.faces.size();
  const auto selected = [&](const SelectionOptions& options) {
    Mesh mesh = all;
    const SelectionResult result = select(mesh, options);
    CHECK(result.selected_faces == mesh.faces.size());
    CHECK(result.selected_faces + result.dropped_faces == all.faces.size());
    return mesh;
  };
  SelectionOptions options;
  CHECK(selected(options).faces == all.faces);
  options.largest = 2;
  CHECK(selected(options).faces.size() == 2 * faces);
  options.around = Vec3(5, 0, 0);
  CHECK(selected(options).positions == ball.positions);
  options.mask.emplace(all.faces.size(), false);
  options.mask->at(faces + 3) = true;
  CHECK(selected(options).faces.size() == 1);
  options.invert = true;
  CHECK(selected(options).faces.size() == all.faces.size() - 1);

  // No face meets both conditions.
  options = {};
  options.box = Box{Vec3(8, -1, -1), Vec3(13, 4, 4)};
  CHECK(selected(options).positions.size() == 8);
  options.around = Vec3(5, 0, 0);
  Mesh mesh = all;
  CHECK_THROWS_AS(select(mesh, options), GoalError);
  CHECK(mesh.faces == all.faces);
  options.mask = std::vector<bool>{true, false};
  CHECK_THROWS_AS(select(mesh, options), InputError);
}
