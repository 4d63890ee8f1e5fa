// Bodies with inner walls of single faces: open meshes with a closed outer skin. Their volumes are
// known in closed form.
#include "corpus/build.h"
#include "corpus/cases.h"

namespace transformesh::corpus {
namespace {

/// A block of unit cells: its skin, and the walls between cells. The orientation of walls
/// alternates along their axis.
Mesh cells(const std::array<int, 3>& size, std::uint64_t seed) {
  Mesh mesh;
  const auto add_square = [&](const Vec3& corner, int axis, bool looks_along) {
    const Vec3 u = Vec3::Unit((axis + 1) % 3), v = Vec3::Unit((axis + 2) % 3);
    Mesh square;
    square.positions = {corner, corner + u, corner + u + v, corner + v};
    square.faces = {{0, 1, 2}, {0, 2, 3}};
    mesh = joined(mesh, looks_along ? square : reversed(square));
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int x = 0; x <= size[0]; ++x)
      for (int y = 0; y <= size[1]; ++y)
        for (int z = 0; z <= size[2]; ++z) {
          const std::array<int, 3> at = {x, y, z};
          if (at[(axis + 1) % 3] == size[(axis + 1) % 3]) continue;
          if (at[(axis + 2) % 3] == size[(axis + 2) % 3]) continue;
          // All faces of a wall have one orientation, otherwise the mesh would be misoriented.
          const bool is_skin = at[axis] == 0 || at[axis] == size[axis];
          const bool looks_along = is_skin ? at[axis] > 0 : (seed + at[axis]) % 2 == 0;
          add_square(Vec3(x, y, z), axis, looks_along);
        }
  return mesh;
}

/// A box with walls across it whose borders lie on its skin, at the given heights.
Mesh box_with_walls(const std::vector<double>& heights, int squares) {
  Mesh mesh = cuboid({0, 0, 0}, {2, 3, 4});
  for (std::size_t i = 0; i < heights.size(); ++i) {
    Mesh wall = grid(squares);
    for (Vec3& p : wall.positions) p = Vec3(2 * p.x(), 3 * p.y(), heights[i]);
    mesh = joined(mesh, i % 2 == 0 ? wall : reversed(wall));
  }
  return mesh;
}

/// A bipyramid with a wall in its middle plane.
Mesh waist(int sides, double radius, double height) {
  Mesh mesh = bipyramid(sides, radius, height, 0.3);
  const auto center = static_cast<Index>(mesh.positions.size());
  mesh.positions.emplace_back(0, 0, 0);
  for (int i = 0; i < sides; ++i)
    mesh.faces.push_back(
        {center, static_cast<Index>(2 + i), static_cast<Index>(2 + (i + 1) % sides)});
  return mesh;
}

double waist_volume(int sides, double radius, double height) {
  const double polygon = sides / 2.0 * radius * radius * std::sin(2 * std::numbers::pi / sides);
  return 2 * polygon * height / 3;
}

void add(Cases& cases, const std::string& name, std::function<Mesh()> make, double volume) {
  Case walls{"walls", name, std::move(make)};
  walls.volume = volume;
  cases.push_back(std::move(walls));
}

}  // namespace

void add_wall_cases(Cases& cases) {
  const std::vector<std::array<int, 3>> sizes = {{2, 1, 1}, {4, 1, 1}, {2, 2, 1}, {3, 2, 2}};
  for (const std::array<int, 3>& size : sizes)
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const std::string name = "cells-" + std::to_string(size[0]) + std::to_string(size[1]) +
                               std::to_string(size[2]) + "/" +
                               named("seed", static_cast<long>(seed));
      const double volume = size[0] * size[1] * size[2];
      add(
          cases, name, [=] { return cells(size, seed); }, volume);
      add(
          cases, name + "/turned", [=] { return turned(cells(size, seed)); }, volume);
      // A second body overlaps half of the first cell and extends half a cell beyond it.
      add(
          cases, name + "/crossed",
          [=] {
            return joined(cells(size, seed), cuboid({-0.5, 0, 0}, {0.5, 1, 1}));
          },
          volume + 0.5);
    }
  for (const int squares : {1, 3}) {
    const std::string name = named("upon-skin", squares);
    add(
        cases, name + "/one", [=] { return box_with_walls({1.25}, squares); }, 24);
    add(
        cases, name + "/three",
        [=] {
          return box_with_walls({0.5, 1.25, 3}, squares);
        },
        24);
  }
  for (const int sides : {3, 12, 60})
    add(
        cases, named("waist", sides), [=] { return waist(sides, 1.5, 2); },
        waist_volume(sides, 1.5, 2));
}

}  // namespace transformesh::corpus
