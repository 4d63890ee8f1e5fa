#include "boolean/selected_cells.h"

#include <doctest/doctest.h>

#include "clean/intersect/find_meetings.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// Returns twice the area of the chosen pieces by direction: -x, +x, -y, +y, -z, +z.
std::array<double, 6> chosen_areas(BooleanOperation operation, const std::vector<Mesh>& meshes) {
  std::vector<Operand> operands;
  for (const Mesh& mesh : meshes) operands.push_back({&mesh});
  const JoinedOperands joined = join_operands(operation, operands);
  const auto welded = std::make_shared<WeldedMesh>(weld(joined.mesh));
  Arrangement arrangement = arrange(welded, find_meetings(*welded, Progress()), Progress());
  std::vector<char> kept(arrangement.pieces.size(), 0);
  choose_selected(operation, joined, WindingAt(), arrangement, kept);
  std::array<double, 6> areas{};
  for (std::size_t p = 0; p < kept.size(); ++p) {
    const auto& [a, b, c] = arrangement.pieces[p].corners;
    const Vec3 ab = arrangement.position(b) - arrangement.position(a);
    const Vec3 normal = ab.cross(arrangement.position(c) - arrangement.position(a));
    for (int i = 0; kept[p] && i < 3; ++i)
      areas[static_cast<std::size_t>(2 * i + (normal[i] > 0 ? 1 : 0))] += std::abs(normal[i]);
  }
  return areas;
}

std::array<double, 6> all(double area) { return {area, area, area, area, area, area}; }

}  // namespace

TEST_CASE("pieces are oriented outwards, for any orientation of the operands") {
  const Mesh large = test::cuboid(Vec3::Zero(), Vec3::Constant(3));
  const Mesh small = test::moved(test::cube(), Vec3::Ones());
  using enum BooleanOperation;
  CHECK(chosen_areas(unite, {large, small}) == all(18));
  CHECK(chosen_areas(intersect, {large, small}) == all(2));
  CHECK(chosen_areas(subtract, {large, small}) == all(20));
  CHECK(chosen_areas(exclude, {small, large}) == all(20));
  CHECK(chosen_areas(subtract, {small, large}) == all(0));
}

TEST_CASE("coincident faces of two operands count for each operand") {
  const Mesh cube = test::cube();
  const Mesh twice = test::joined(cube, cube);
  using enum BooleanOperation;
  CHECK(chosen_areas(unite, {twice, cube}) == all(2));
  CHECK(chosen_areas(intersect, {twice, cube}) == all(2));
  CHECK(chosen_areas(subtract, {twice, cube}) == all(0));
  CHECK(chosen_areas(exclude, {twice, cube}) == all(0));
  CHECK(chosen_areas(exclude, {twice, cube, cube}) == all(2));
  // The sum of the winding jumps at the common face is 0, yet the face separates inside from
  // outside.
  const Mesh beside = test::reversed(test::moved(cube, Vec3(1, 0, 0)));
  const auto areas = chosen_areas(subtract, {cube, test::joined(beside, beside)});
  CHECK(areas == all(2));
}
