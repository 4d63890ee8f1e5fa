#include "clean/open/enclosed_sheets.h"

#include <doctest/doctest.h>

#include "helpers/arrangement_facts.h"

using namespace transformesh;

namespace {

/// A box from x = 0 to x = 2, and a wall of single faces across it at `x`.
Mesh box_with_wall(double x, bool is_reversed = false) {
  Mesh mesh = test::cuboid({0, 0, 0}, {2, 1, 1});
  const auto base = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x, 1, 0}, {x, 1, 1}, {x, 0, 1}});
  Mesh wall{mesh.positions, {{base, base + 1, base + 2}, {base, base + 2, base + 3}}, {}, {}};
  if (is_reversed) wall = test::reversed(wall);
  mesh.faces.insert(mesh.faces.end(), wall.faces.begin(), wall.faces.end());
  return mesh;
}

std::size_t enclosed_faces(const Mesh& mesh, int winding_level = 1) {
  const auto marks = find_enclosed_sheets(test::arranged(mesh), winding_level, Progress());
  return static_cast<std::size_t>(
      std::ranges::count_if(marks, [](char mark) { return mark != 0; }));
}

}  // namespace

TEST_CASE("a wall between two rooms that occurs once is enclosed, in either orientation") {
  CHECK(enclosed_faces(box_with_wall(1)) == 2);
  CHECK(enclosed_faces(box_with_wall(1, true)) == 2);
}

TEST_CASE("no face of a closed body is enclosed, also of bodies that touch or intersect") {
  const Mesh left = test::cuboid({0, 0, 0}, {1, 1, 1}), right = test::cuboid({1, 0, 0}, {2, 1, 1});
  CHECK(enclosed_faces(left) == 0);
  CHECK(enclosed_faces(test::joined(left, right)) == 0);
  CHECK(enclosed_faces(test::random_balls(2, 3)) == 0);
}

TEST_CASE("a wall in a body with a hole is not enclosed") {
  Mesh open = box_with_wall(1);
  open.faces.erase(open.faces.begin() + 8, open.faces.begin() + 10);  // the side x = 0
  CHECK(enclosed_faces(open) == 0);
}
